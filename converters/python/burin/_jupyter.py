"""How drawings show themselves in notebooks, beside `Drawing._repr_svg_`, which is the kernel's."""

import html

from ._burin import Book, Drawing

# Pixels: as wide as the text of a notebook.
_WIDTH = 900


def _drawing_html(self):
    """A drawing with numbers or a parts list is the page on which both point at each other; None: any other is its SVG."""
    if not self.items:
        return None
    page = html.escape(self.to_bytes("html").decode("utf-8"), quote=True)
    width, height = self.paper
    tall = round(_WIDTH * height / width) + 60
    return f'<iframe srcdoc="{page}" style="width: 100%; max-width: {_WIDTH}px; height: {tall}px; border: 0"></iframe>'


def _book_html(self):
    """A step book is its steps one below the other."""
    out = [f"<h2>{html.escape(self.title)}</h2>"]
    for number, page in enumerate(self.pages, 1):
        # Ids of one page would hide those of another.
        svg = page["drawing"].to_bytes("svg", id_prefix=f"step{number}-").decode("utf-8")
        out.append(svg[svg.index("<svg") :])
    return "\n".join(out)


def set_up():
    """Gives both classes what notebooks ask for."""
    Drawing._repr_html_ = _drawing_html
    Book._repr_html_ = _book_html
