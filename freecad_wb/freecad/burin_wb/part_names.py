"""What parts are called in illustration files: names that no other part has, and that are no patterns of selectors."""

import re


def plain(label):
    """A label without what selectors mean by letters."""
    return re.sub(r"[/*?]", "-", label).lstrip("@").strip() or "part"


def distinct(labels):
    """A name for each label, in order: of labels that are the same the second ends with #2, and so on, as the kernel's readers have it,
    which knows by that what is one item."""
    taken, names = set(), []
    for label in labels:
        name, number = plain(label), 1
        while name in taken:
            number += 1
            name = f"{plain(label)} #{number}"
        taken.add(name)
        names.append(name)
    return names


def unnumbered(name):
    """A name without the number that `distinct`, now or in former versions, may have given it."""
    return re.sub(r" #?\d+$", "", name)
