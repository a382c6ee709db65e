#!/usr/bin/env python3
"""Builds the manual as a site, and checks the links of all Markdown pages.

    kernel/docs/site.py --check     checks each relative link and anchor of each Markdown page of the project
    kernel/docs/site.py             checks, then builds build/docs/site with MkDocs (./dev docs)

The pages link to pages, pictures and sources all over the project. So all pages, and all that they link to, are copied to
build/docs/source with the same relative paths, and MkDocs builds from there by kernel/docs/mkdocs.yml. A folder that a page
links to is its README.md, or a page that lists its files. Status 1, with a line for each link that leads nowhere."""
import argparse
import html
import html.parser
import os
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]
CONFIG = ROOT / "kernel/docs/mkdocs.yml"
FENCE = re.compile(r"^\s*(```|~~~)")
ITEM = re.compile(r"^(\s*)([-*+]|\d+[.)])\s")
CODE = re.compile(r"(`+)(?:(?!`).|(?!\1(?!`))`)*?\1(?!`)")
# [text](target), ![text](target), a link around a picture, and the same in HTML; group 2 is the target.
LINK = re.compile(r"(\]\(\s*<?)([^()\s<>]+(?:\([^()\s]*\)[^()\s<>]*)*)(?=>?(?:\s+\"[^\"]*\")?\s*\))|(?<=href=\")()([^\"]+)(?=\")|(?<=src=\")()([^\"]+)(?=\")")


def project_files():
    """All files of the project, as paths from its root: those that Git knows or would add; without Git, all but builds."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                            capture_output=True, text=True)
    if listed.returncode == 0 and listed.stdout:
        return {name for name in listed.stdout.split("\0") if name and (ROOT / name).is_file()}
    skipped = {"build", "out", "__pycache__", ".git"}
    found = (path.relative_to(ROOT) for path in ROOT.rglob("*") if path.is_file())
    return {path.as_posix() for path in found if not skipped & set(path.parts)}


def marked_lines(text):
    """(line, whether it is code) of each line of a page."""
    fence, listed, blank, indented = None, False, True, False
    for line in text.splitlines(keepends=True):
        mark = FENCE.match(line)
        if fence:
            yield line, True
            fence = None if mark and mark[1] == fence else fence
            continue
        if mark:
            fence = mark[1]
            yield line, True
            continue
        if ITEM.match(line):
            listed = True
        elif line.strip() and not line[0].isspace():
            listed = False
        # Four blanks begin a block of code after an empty line; in a list they continue an item.
        indented = line.startswith("    ") and not listed and (blank or indented)
        yield line, indented
        blank = not line.strip()


def outside_code(line):
    """(text, whether it is code) of each stretch of a line."""
    place = 0
    for span in CODE.finditer(line):
        yield line[place:span.start()], False
        yield span[0], True
        place = span.end()
    yield line[place:], False


def links(text):
    """(line number, target) of each relative link."""
    for number, (line, is_code) in enumerate(marked_lines(text), 1):
        if is_code:
            continue
        # Code becomes a mark of its own: it may be the text of a link, but holds none.
        plain = "".join("`" if code else part for part, code in outside_code(line))
        for match in LINK.finditer(plain):
            target = match[2] or match[4] or match[6]
            if not re.match(r"[a-zA-Z][a-zA-Z0-9+.-]*:|//", target):
                yield number, html.unescape(target)


def slug(heading):
    """The anchor of a heading, as Git hosts and the site make it."""
    text = re.sub(r"!?\[([^]]*)\]\([^)]*\)", r"\1", heading)
    text = re.sub(r"</?[^>]*>", "", text.replace("`", ""))
    text = re.sub(r"(?<!\w)[*_]+(?=\S)|(?<=\S)[*_]+(?!\w)", "", text)
    return re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", "-")


def anchors(text):
    """{anchor: how many headings of the page have it}"""
    found = {}
    for line, is_code in marked_lines(text):
        if is_code:
            continue
        heading = re.match(r"#{1,6}\s+(.*?)\s*#*\s*$", line)
        names = [slug(heading[1])] if heading else []
        for name in names + re.findall(r'\b(?:id|name)="([^"]+)"', line):
            found[name] = found.get(name, 0) + 1
    return found


class Pages:
    def __init__(self):
        self.files = project_files()
        self.folders = {str(parent) for name in self.files for parent in pathlib.PurePosixPath(name).parents}
        self.texts = {name: (ROOT / name).read_text(encoding="utf-8") for name in sorted(self.files) if name.endswith(".md")}
        self.anchors = {name: anchors(text) for name, text in self.texts.items()}

    def target(self, page, link):
        """(path from the root, anchor) that a link of a page leads to."""
        path, _, anchor = link.partition("#")
        path = urllib.parse.unquote(path)
        full = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
        return full, urllib.parse.unquote(anchor)

    def fault(self, page, link):
        """What is wrong with a link, or None."""
        path, anchor = self.target(page, link)
        if path in self.folders:
            path = os.path.normpath(os.path.join(path, "README.md")) if anchor else path
        elif path not in self.files:
            return "no such file"
        if not anchor or path not in self.texts:
            return None
        count = self.anchors[path].get(anchor, 0)
        return None if count == 1 else "no such heading" if count == 0 else "several headings have this anchor"

    def faults(self):
        for page, text in self.texts.items():
            for number, link in links(text):
                fault = self.fault(page, link)
                if fault:
                    yield f"{page}:{number}: {link}: {fault}"


def site_path(path):
    """Where a file of the project stands in the site; MkDocs leaves out what begins with a dot."""
    return re.sub(r"(^|/)\.(?=[^./])", r"\1dot-", path)


class Lists:
    """The lists that a line of a page is in. For MkDocs what belongs to an item stands four blanks farther in than the item;
    for Git hosts, below the first letter of its text."""

    def __init__(self):
        self.open, self.shift = [], 0  # where the text of each open item begins

    def indented(self, line, is_code):
        stripped = line.lstrip(" ")
        indent = len(line) - len(stripped)
        item = None if is_code else ITEM.match(line)
        if not line.strip():
            return line
        if not (is_code and FENCE.match(line) is None):  # the lines of a fence move with it
            inside = [text for text in self.open if text <= indent]
            if item or indent == 0:
                self.open = inside
            self.shift = 4 * len(inside) - (inside[-1] if inside else 0)
        if item:
            self.open = self.open + [len(item[0])]
            return " " * (4 * (len(self.open) - 1)) + stripped
        return " " * max(0, self.shift) + line


class Source:
    """The folder that the site is built from."""

    def __init__(self, pages, folder):
        self.pages, self.folder = pages, folder
        shutil.rmtree(folder, ignore_errors=True)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def copy(self, name):
        path = self.folder / site_path(name)
        if not path.exists():
            path.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, path)

    def page_of(self, folder):
        """The page that stands for a folder."""
        readme = os.path.normpath(os.path.join(folder, "README.md"))
        if readme in self.pages.texts:
            return readme
        index = os.path.join(folder, "index.md")
        inside = sorted(file for file in self.pages.files if file.startswith(folder + "/") and file not in self.pages.texts)
        names = [file[len(folder) + 1:] for file in inside]
        rows = [f"- [{name}]({urllib.parse.quote(site_path(name))})" for name in names]
        for file in inside:
            self.copy(file)
        self.write(index, f"# {folder}\n\n" + "\n".join(rows) + "\n")
        return index

    def link(self, page, link):
        """A link as the site has it; what it leads to is copied."""
        path, anchor = self.pages.target(page, link)
        if path in self.pages.folders:
            path = self.page_of(path)
            relative = os.path.relpath(path, os.path.dirname(page) or ".")
            return urllib.parse.quote(relative) + ("#" + anchor if anchor else "")
        if path in self.pages.files and path not in self.pages.texts:
            self.copy(path)
            return site_path(link)
        return link

    def page(self, name):
        """A page in the Markdown of MkDocs, which differs from that of Git hosts in lists and in code within tables."""
        out, lists, was_text, paragraph = [], Lists(), False, False
        for line, is_code in marked_lines(self.pages.texts[name]):
            if not is_code:
                line = "".join(self.stretch(name, line, part, code) for part, code in outside_code(line))
            # A list needs an empty line after a paragraph.
            item = not is_code and ITEM.match(line)
            if item and was_text and paragraph:
                out.append("\n")
            if item or not was_text:
                paragraph = not item and not is_code
            line = lists.indented(line, is_code)
            was_text = bool(line.strip()) and not is_code
            out.append(line)
        self.write(name, "".join(out))

    def stretch(self, name, line, part, is_code):
        if is_code:  # In a table a bar within code needs no backslash here, and would show it.
            return part.replace("\\|", "|") if line.startswith("|") else part

        def changed(match):
            target = match[2] or match[4] or match[6]
            if re.match(r"[a-zA-Z][a-zA-Z0-9+.-]*:|//", target):
                return match[0]
            return (match[1] or "") + self.link(name, html.unescape(target))

        return LINK.sub(changed, part)


def title(text):
    return next((line[2:].strip().replace("`", "") for line in text.splitlines() if line.startswith("# ")), "")


def other_pages(pages, nav):
    """Sections for pages that `nav` does not have: those of the modules, measurements, and others."""
    listed = set(re.findall(r"[\w./-]+\.md", str(nav)))
    sections = {"Modules": [], "Measurements": [], "Other pages": []}
    for name, text in pages.texts.items():
        if name in listed:
            continue
        module = name.endswith("README.md") and name.startswith(("kernel/", "converters/"))
        section = "Modules" if module else "Measurements" if name.startswith("tests/bench/") else "Other pages"
        sections[section].append({title(text) or name: name})
    return [{section: rows} for section, rows in sections.items() if rows]


class Site(html.parser.HTMLParser):
    """Links and anchors of a page of the site."""

    def __init__(self, path):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors |= {values[name] for name in ("id", "name") if values.get(name)}
        self.links += [values[name] for name in ("href", "src") if values.get(name)]


def site_faults(folder):
    """A line for each link of the built site that leads nowhere."""
    # 404.html stands for any address, so its links begin at the root of the server.
    pages = {path: Site(path) for path in sorted(folder.rglob("*.html")) if path.name != "404.html"}
    for path, page in pages.items():
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            name = urllib.parse.unquote(parts.path)
            target = pathlib.Path(os.path.normpath(path.parent / name)) if name else path
            target = target / "index.html" if target.is_dir() else target
            anchor = urllib.parse.unquote(parts.fragment)
            if not target.exists() or (anchor and target in pages and anchor not in pages[target].anchors):
                yield f"{path.relative_to(folder)}: {link}: leads nowhere"


def build(pages):
    try:
        import mkdocs.commands.build
        import mkdocs.config
        import mkdocs.exceptions
    except ImportError:
        sys.exit("site.py: MkDocs is missing: install Debian's packages mkdocs and python3-pymdownx, or run ./dev docs")
    source, site = ROOT / "build/docs/source", ROOT / "build/docs/site"
    staged = Source(pages, source)
    for name in pages.texts:
        staged.page(name)
    config = mkdocs.config.load_config(str(CONFIG), docs_dir=str(source), site_dir=str(site), strict=True)
    config["nav"] = config["nav"] + other_pages(pages, config["nav"])
    try:
        mkdocs.commands.build.build(config)
    except mkdocs.exceptions.MkDocsException as error:
        sys.exit(f"site.py: the site was not built: {error}".replace("\n", " "))
    return list(site_faults(site))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="check the links; build nothing")
    arguments = parser.parse_args()
    pages = Pages()
    faults = list(pages.faults())
    if not faults and not arguments.check:
        faults = build(pages)
    if faults:
        sys.exit("\n".join(faults + [f"site.py: {len(faults)} links lead nowhere"]))
    count = sum(1 for text in pages.texts.values() for _ in links(text))
    print(f"{len(pages.texts)} pages, {count} relative links: each leads somewhere")


main()
