"""Other numbers for items; as item_numbers has them."""

import math


def renumbered(numbers, old, new):
    """The item `old` has the number `new` from now on; what has that gets the other."""
    changed = {number: name for number, name in numbers.items() if number not in (old, new)}
    changed[new] = numbers[old]
    if new in numbers and new != old:
        changed[old] = numbers[new]
    return changed


def in_order(items):
    """Numbers from 1 in the order of the assembly, without holes."""
    ordered = sorted(items, key=lambda item: min(item["parts"]))
    return {str(number): item["name"] for number, item in enumerate(ordered, 1)}


def clockwise(items, places):
    """Numbers from 1 around the drawing, from the top on; items that it does not number follow in the order of the assembly. `places`:
    number to where it stands on the sheet, y up."""
    x, y = (sum(at[k] for at in places.values()) / max(len(places), 1) for k in (0, 1))

    def turn(item):
        at = places.get(item["number"])
        return math.inf if at is None else math.atan2(at[0] - x, at[1] - y) % (2 * math.pi)

    ordered = sorted(items, key=lambda item: (turn(item), min(item["parts"])))
    return {str(number): item["name"] for number, item in enumerate(ordered, 1)}


def places_of(sheet):
    """Where the numbers of a drawing stand; `sheet`: a features.sheet.Sheet."""
    texts = [text for layer in sheet.data["layers"] for text in layer.get("texts", ()) if text["role"] == "callout"]
    return {text["item"]: tuple(text["at"]) for text in texts}
