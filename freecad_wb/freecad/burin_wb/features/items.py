"""Numbers of items, as the property ItemNumbers keeps them: text of a number to the name of what has it."""


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


def kept(numbers, items):
    """Kept numbers with those of items added."""
    return {**numbers, **{str(item["number"]): item["name"] for item in items}}
