"""Drawings as TechDraw takes them: symbols that come out whole and at exact scale."""

import collections
import math
import re

from .. import preferences

# mm of paper kept around the ink of a symbol that is trimmed to it.
AROUND = 0.5

# Qt reads the first 32,767 elements of a path and leaves out the rest without a word.
MOST_ELEMENTS = 30_000

# The part of the sheet that a symbol shows, in mm; left and top are counted from the sheet's top left.
Window = collections.namedtuple("Window", "left top width height")

_INK = re.compile(r'data-ink="(\S+) (\S+) (\S+) (\S+)"')
_SIZE = re.compile(r'width="[^"]*mm" height="[^"]*mm" viewBox="[^"]*"')
_SCALE = re.compile(r'width="(\d+)" height="\d+" viewBox="\S+ \S+ (\S+) ')
# Qt takes one family of a text; osifont is TechDraw's own, of the same letters as the kernel's.
_FONTS, _FONT = 'font-family="osifont, sans-serif"', 'font-family="osifont"'
# Qt 6 strokes what it fills in a PDF with a pen of a whole unit, where no other width is said.
_NONE, _NO_WIDTH = ' stroke="none"', ' stroke="none" stroke-width="0"'
_PATH = re.compile(r'<path([^>]*?) d="([^"]*)"/>')


def window_of(svg, width, height, trim):
    """What a symbol shows of a sheet: all of it, or its ink and a little around; pictures of older versions do not tell
    where their ink is."""
    ink = _INK.search(svg, 0, 2000) if trim else None
    if ink is None:
        return Window(0.0, 0.0, width, height)
    left, top, right, bottom = (float(n) for n in ink.groups())
    return Window(left - AROUND, top - AROUND, right - left + 2 * AROUND, bottom - top + 2 * AROUND)


def symbol_size(window):
    """What a symbol takes on the page, in mm: Qt rounds a symbol's size to whole pixels."""
    pixels = preferences.pixels_per_mm()
    return math.ceil(window.width * pixels) / pixels, math.ceil(window.height * pixels) / pixels


def to_symbol(svg, window):
    """The text of an SVG file in mm as the text of a symbol: size in whole pixels, user unit 1 mm of paper."""
    pixels = preferences.pixels_per_mm()
    w, h = symbol_size(window)
    head = (
        f'width="{round(w * pixels)}" height="{round(h * pixels)}" '
        f'viewBox="{window.left:.6f} {window.top:.6f} {w:.6f} {h:.6f}"'
    )
    text, count = _SIZE.subn(head, svg, count=1)
    if count != 1:
        raise ValueError("the SVG text has no size in millimetres")
    return parted(text.replace(_FONTS, _FONT).replace(_NONE, _NO_WIDTH))


def pixels_of(symbol):
    """The pixels of a symbol that its maker took for a millimetre; nothing where it does not say."""
    found = _SCALE.search(symbol, 0, 2000)
    return int(found.group(1)) / float(found.group(2)) if found else None


def parted(svg):
    """Pictures that older versions kept, one path a pen however long that is, without paths that Qt would cut short."""
    return svg if _INK.search(svg, 0, 2000) else _PATH.sub(_parts, svg)


def _parts(match):
    pen, data = match.groups()
    if _elements(data) <= MOST_ELEMENTS:
        return match.group(0)
    parts, size = [[]], 0
    for line in data.split("M")[1:]:
        count = _elements(line) + 1
        if size + count > MOST_ELEMENTS and parts[-1]:
            parts.append([])
            size = 0
        parts[-1].append("M" + line)
        size += count
    paths = "\n".join(f'<path{pen} d="{"".join(part)}"/>' for part in parts)
    return f"<g>\n{paths}\n</g>"


def _elements(data):
    """No fewer elements than path data has: each takes a number at least, or is a closing."""
    return sum(data.count(sign) for sign in " -Mlhvcz")
