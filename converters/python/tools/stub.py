"""Writes the type stub of the built package: stub.py TEMPLATE OUTPUT, with the package on PYTHONPATH. The keywords of
`draw` and their manual come from the kernel's options."""

import pathlib
import sys

from burin import _draw

template, output = map(pathlib.Path, sys.argv[1:])
lines = [f"    {name}: {kind} = {default!r},\n" for name, kind, default, _ in _draw.KEYWORDS]
manual = _draw.draw.__doc__.rstrip().replace("\\", "\\\\").replace("\n", "\n    ").replace("\n    \n", "\n\n")
text = template.read_text().replace("@draw_keywords@", "".join(lines)).replace("@draw_manual@", manual)
output.write_text(text)
