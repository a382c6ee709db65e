"""Numbers of items, as the property ItemNumbers keeps them: text of a number to the name of what has it."""


def for_kernel(numbers):
    """As an illustration says them: a name that no item has any more is kept for it, and renames none."""
    return {number: {"name": name} for number, name in numbers.items()}


def names_of(said):
    """The numbers and names of what `for_kernel` made."""
    return {number: item["name"] for number, item in said.items()}


def kept(numbers, items):
    """Kept numbers with those of items added."""
    return {**numbers, **{str(item["number"]): item["name"] for item in items}}
