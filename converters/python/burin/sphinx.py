"""Drawings of models in documents of Sphinx: `extensions = ["burin.sphinx"]`, then

    .. burin:: pump.step
       :style: technical
       :explode: auto
       :callouts:
       :list:

       The pump, taken apart.

SVG in pages, PDF in LaTeX. kernel/docs/manuals.md lists options and settings.
"""

import os
import shutil
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any, ClassVar

import burin
from burin.batch.errors import BatchError
from burin.book.figures import Figure, FigureError, Made, Studio
from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.application import Sphinx
from sphinx.directives.patches import Figure as FigureDirective
from sphinx.environment import BuildEnvironment
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective
from sphinx.util.osutil import relative_uri

_LOGGER = logging.getLogger(__name__)
_STEP_ITEMS = 6
# Formats beside the one of the builder, by the suffix that Sphinx looks for: SVG in HTML and EPUB, PDF in LaTeX.
_FORMATS = ["svg", "pdf"]
# Of both, docutils and us: docutils has the name, ours is burin-NAME.
_TAKEN = frozenset(FigureDirective.option_spec)
# What is no part of one figure, or said by the file and the settings.
_NOT_HERE = frozenset({"threads", "verify", "parts_list", "id_prefix"})


def _text_or_nothing(argument: str | None) -> str:
    """`:callouts:` is a switch that is on."""
    return "true" if argument is None or not argument.strip() else argument.strip()


def _whole_or_nothing(argument: str | None) -> int:
    return _STEP_ITEMS if argument is None or not argument.strip() else directives.positive_int(argument)


def draw_options() -> dict[str, str]:
    """Options of the directive that are those of `burin draw`: the name here -> the name there."""
    names = [str(option["name"]) for option in burin.catalogues()["options"]]
    spelled = {name: name.rstrip("_").replace("_", "-") for name in names if name not in _NOT_HERE}
    return {f"burin-{word}" if word in _TAKEN else word: name for name, word in spelled.items()}


class page_link(nodes.General, nodes.Inline, nodes.TextElement):
    """The way to the page of a figure, where what is built has pages."""


class BurinDirective(FigureDirective, SphinxDirective):
    """A figure whose picture is drawn. One argument: the model, from the document's folder, or from the top after a /;
    several with ; between them."""

    final_argument_whitespace = True
    draws: ClassVar[dict[str, str]] = {}
    option_spec: ClassVar[dict[str, Callable[[str], Any]]] = dict(FigureDirective.option_spec)

    def run(self) -> list[nodes.Node]:
        settings = self.env.app.config
        given = {key: self.options.pop(key) for key in list(self.options) if key in self.draws}
        options = {key: [str(v) for v in (value if isinstance(value, list) else [value])] for key, value in settings.burin_options.items()}
        for key, value in given.items():
            # A line is a value of an option that may be given several times.
            options[self.draws[key]] = [line.strip() for line in value.split("\n") if line.strip()]
        steps, page, listed = self.options.pop("steps", None), "page" in self.options, "list" in self.options
        for key in ("page", "list"):
            self.options.pop(key, None)
        models = [self.env.relfn2path(word.strip())[0] for word in self.arguments[0].split(";")]
        for model in models:
            self.env.note_dependency(os.path.join(self.env.srcdir, model))
        formats = _FORMATS + (["html"] if page and steps is None else [])
        figure = Figure("", models, options, formats, listed, steps)
        try:
            studio = _studio(self.env.app)
            figure.name = studio.name_of(figure)
            made = studio.make(figure)
        except (FigureError, BatchError) as e:
            return [self.state.document.reporter.warning(f"burin: {e}", line=self.lineno)]
        for file in made.read:
            self.env.note_dependency(os.path.join(self.env.srcdir, file))
        for words in made.diagnostics:
            _LOGGER.info("burin: %s", words, location=self.get_location())
        used = _used(self.env).setdefault(self.env.docname, set())
        used.update(made.pictures, [f"{figure.name}.items.json"] if listed else [])
        self.options.setdefault("alt", f"Drawing of {', '.join(os.path.basename(m) for m in models)}")
        return self._steps(made, listed) if steps is not None else self._figure(figure, made, page)

    def _uri(self, picture: str) -> str:
        """As Sphinx looks for pictures of a builder: any suffix."""
        return f"/{self.env.app.config.burin_folder}/{os.path.splitext(picture)[0]}.*"

    def _figure(self, figure: Figure, made: Made, page: bool) -> list[nodes.Node]:
        self.arguments[0] = self._uri(made.pictures[0])
        out = list(super().run())
        if page:
            link = page_link("", page=f"{figure.name}.html")
            out.append(nodes.paragraph("", "", link, classes=["burin-page"]))
        return out + ([_table(made.items)] if made.items else [])

    def _steps(self, made: Made, listed: bool) -> list[nodes.Node]:
        out: list[nodes.Node] = []
        for step in made.pages:
            words = nodes.bullet_list(bullet="-")
            for part in step.added:
                number = f" ({part['item']})" if part["item"] else ""
                text = f"{part['quantity']} × {part['name']}{number}"
                words += nodes.list_item("", nodes.paragraph("", text))
            image = nodes.image("", uri=self._uri(step.pictures[0]), alt=step.heading)
            for key in ("width", "height", "align"):
                if key in self.options:
                    image[key] = self.options[key]
            # Of LaTeX no page may break between what a step adds and its picture.
            keep, end = (nodes.raw("", f"\\par\\{word}{{samepage}}", format="latex") for word in ("begin", "end"))
            out += [nodes.rubric("", step.heading), keep, words, image, end]
        return out + ([_table(made.items)] if listed and made.items else [])


def _table(items: list[dict[str, Any]]) -> nodes.table:
    """The parts list."""

    def row(cells: Iterable[str]) -> nodes.row:
        return nodes.row("", *(nodes.entry("", nodes.paragraph("", cell)) for cell in cells))

    group = nodes.tgroup("", cols=3)
    group += [nodes.colspec("", colwidth=width) for width in (8, 8, 60)]
    group += nodes.thead("", row(("No.", "Qty", "Name")))
    group += nodes.tbody("", *(row((str(i["number"]), str(i["quantity"]), str(i["name"]))) for i in items))
    return nodes.table("", group, classes=["burin-parts"])


class _SphinxStudio(Studio):
    def name_of(self, figure: Figure) -> str:
        """The same figure in several documents is one file; another one does not take its place."""
        stem = Path(figure.inputs[0]).name.split(".")[0] or "figure"
        return f"{stem}-{self._id(figure, figure.formats + ['list'] * figure.parts_list)[:12]}"


def _open(app: Sphinx, env: BuildEnvironment, docnames: list[str]) -> None:
    """What draws, or why nothing does. Once a build, before processes part to read documents: a studio asks the command for its
    version."""
    if docnames:
        try:
            app.burin_studio = _new_studio(app)  # type: ignore[attr-defined]
        except BatchError as e:
            app.burin_studio = e  # type: ignore[attr-defined]


def _new_studio(app: Sphinx) -> _SphinxStudio:
    out = Path(app.srcdir) / app.config.burin_folder
    return _SphinxStudio(Path(app.srcdir), out, app.config.burin_command, float(app.config.burin_timeout))


def _studio(app: Sphinx) -> _SphinxStudio:
    """That of the build. Throws BatchError where there is no command."""
    if not hasattr(app, "burin_studio"):
        _open(app, app.env, [app.env.docname])
    if isinstance(app.burin_studio, BatchError):
        raise app.burin_studio
    return app.burin_studio  # type: ignore[no-any-return]


def _used(env: BuildEnvironment) -> dict[str, set[str]]:
    """The files that each document shows."""
    if not hasattr(env, "burin_used"):
        env.burin_used = {}  # type: ignore[attr-defined]
    return env.burin_used  # type: ignore[attr-defined, no-any-return]


def _forget(app: Sphinx, env: BuildEnvironment, docname: str) -> None:
    _used(env).pop(docname, None)


def _merge(app: Sphinx, env: BuildEnvironment, docnames: Iterable[str], other: BuildEnvironment) -> None:
    for name in docnames:
        if name in _used(other):
            _used(env)[name] = _used(other)[name]


def _link_pages(app: Sphinx, doctree: nodes.document, docname: str) -> None:
    for link in list(doctree.findall(page_link)):
        if app.builder.format != "html":
            link.parent.parent.remove(link.parent)
            continue
        to = f"{app.config.burin_folder}/{link['page']}"
        reference = nodes.reference("", app.config.burin_page_text, refuri=relative_uri(app.builder.get_target_uri(docname), to))
        link.replace_self(reference)


def _finish(app: Sphinx, exception: Exception | None) -> None:
    """Pages go beside what was built; drawings that no document shows any more go."""
    if exception is not None:
        return
    folder = Path(app.srcdir) / app.config.burin_folder
    wanted = {name for names in _used(app.env).values() for name in names}
    if app.builder.format == "html":
        for name in sorted(n for n in wanted if n.endswith(".html")):
            target = Path(app.outdir) / app.config.burin_folder / name
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(folder / name, target)
    for path in folder.glob("*-*"):
        if path.is_file() and path.name not in wanted:
            path.unlink()


def setup(app: Sphinx) -> dict[str, Any]:
    """Called by Sphinx."""
    BurinDirective.draws = draw_options()
    BurinDirective.option_spec = {
        **FigureDirective.option_spec,
        **{name: _text_or_nothing for name in BurinDirective.draws},
        "steps": _whole_or_nothing,
        "page": directives.flag,
        "list": directives.flag,
    }
    app.add_config_value("burin_options", {}, "env")
    app.add_config_value("burin_folder", "_burin", "env")
    app.add_config_value("burin_command", None, "")
    app.add_config_value("burin_timeout", 300, "")
    app.add_config_value("burin_page_text", "Open this figure as a page of its own", "html")
    app.add_node(page_link)
    app.add_directive("burin", BurinDirective)
    app.connect("env-before-read-docs", _open)
    app.connect("env-purge-doc", _forget)
    app.connect("env-merge-info", _merge)
    app.connect("doctree-resolved", _link_pages)
    app.connect("build-finished", _finish)
    return {"version": burin.__version__, "parallel_read_safe": True, "parallel_write_safe": True, "env_version": 1}
