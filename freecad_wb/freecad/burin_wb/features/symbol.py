"""Drawings as TechDraw takes them: symbols that come out at exact scale."""

import math
import re

# TechDraw takes this many pixels of a symbol for a millimetre of paper, and Qt rounds a symbol's size to whole pixels.
PIXELS_PER_MM = 3.78


def symbol_size(width, height):
    """What a symbol of a sheet takes on the page, in mm."""
    return math.ceil(width * PIXELS_PER_MM) / PIXELS_PER_MM, math.ceil(height * PIXELS_PER_MM) / PIXELS_PER_MM


def to_symbol(svg, width, height):
    """The text of an SVG file in mm as the text of a symbol: size in whole pixels, user unit 1 mm of paper."""
    w, h = math.ceil(width * PIXELS_PER_MM), math.ceil(height * PIXELS_PER_MM)
    head = (
        f'width="{w}" height="{h}" viewBox="0 0 {w / PIXELS_PER_MM:.6f} {h / PIXELS_PER_MM:.6f}"'
    )
    text, count = re.subn(r'width="[^"]*mm" height="[^"]*mm" viewBox="[^"]*"', head, svg, count=1)
    if count != 1:
        raise ValueError("the SVG text has no size in millimetres")
    return text
