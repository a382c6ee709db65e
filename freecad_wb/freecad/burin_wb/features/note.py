"""Notes: what they say and point at. They are dimensions of the kind Note: objects that follow faces, edges and vertices, and whole
objects too."""

from ..text import tr
from .chosen import is_selector, numbers_of_path
from .found import drawn, for_kernel, left_out
from .looks import path_of

NOTE = "Note"


def lines_of(text):
    """A text whose lines may be parted by a backslash and n, too, as one types them into a field of one line."""
    return text.replace("\\n", "\n")


def words_of(one):
    """What a note says."""
    return lines_of(one.Text).strip()


def problem(one, found):
    """Why a note cannot be drawn, empty where it can be. `found`: what it points at."""
    if not found and one.Place.Length == 0:
        return tr("its features are gone; choose its Features again, or delete it")
    if not words_of(one) and not one.Symbol:
        return tr("it has no words; write some in Text, or choose a Symbol")
    return ""


def said(one, found, parts):
    """As the kernel takes it. Throws Refused."""
    at = [target(each, parts) for each in found]
    row = {"text": words_of(one)}
    if at:
        row["at"] = at[0] if len(at) == 1 else at
    if one.Place.Length > 0:
        row["place"] = [one.Place.x, one.Place.y]
    if one.Frame and not one.Symbol:  # a symbol has its own outline
        row["frame"] = True
    if one.Mark != "Auto":
        row["mark"] = one.Mark.lower()
    if one.Symbol:
        row["symbol"] = one.Symbol
        row.update((key, _value(text)) for key, text in dict(one.SymbolKeys).items() if key.startswith(f"{one.Symbol}_"))
    return row


def target(found, parts):
    """What a leader leads to, as the kernel takes it. `parts`: PartJobs. Throws Refused."""
    sources = [part.source if part.drawn else "" for part in parts]
    if found.shape is not None:
        return for_kernel(*drawn(found, sources))
    path = path_of(found.top, found.sub)
    numbers = numbers_of_path(path, sources) or [k for k, source in enumerate(sources) if source and f"{path}.".startswith(f"{source}.")]
    if not numbers:
        raise left_out(path)
    return {"part": _assembly(numbers, parts) if len(numbers) > 1 else f"@index={numbers[0]}"}


def _assembly(numbers, parts):
    """A selector of the assembly that has these parts and no others: the kernel points at one that is seen. Else of the first of them."""
    paths = [part.assembly for part in parts]
    depth, first = 0, paths[numbers[0]]
    while depth < min(len(paths[k]) for k in numbers) and all(paths[k][depth] == first[depth] for k in numbers):
        depth += 1
    above = first[:depth]
    within = [k for k, (path, part) in enumerate(zip(paths, parts)) if path[:depth] == above and part.drawn]
    clear = depth and within == numbers and not any(map(is_selector, above)) and not any(part.assembly + [part.name] == above for part in parts)
    return "/" + "/".join(above) if clear else f"@index={numbers[0]}"


def _value(text):
    """An option of a symbol: a number or a word."""
    try:
        number = float(text)
    except ValueError:
        return text
    return int(number) if number.is_integer() else number


def option_of(value):
    """The other way round."""
    return value if isinstance(value, str) else f"{value:g}"
