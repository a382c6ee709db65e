"""Words by which properties name parts: paths or names of objects, as Looks has them, and selectors of the kernel."""

_MARKS = "*?/@"


def is_selector(word):
    """Whether the kernel is to say what a word means; names of objects have none of these letters."""
    return any(mark in word for mark in _MARKS)


def numbers_of(word, sources):
    """Numbers of the parts, by their paths, that an object's path or name means; of an assembly all in it."""
    inside = f".{word}."
    return [k for k, source in enumerate(sources) if inside in f".{source}."]


def selectors(words, sources):
    """What the kernel is asked for, and the words that name nothing here."""
    found, asked, lost = set(), [], []
    for word in words:
        if is_selector(word):
            asked.append(word)
            continue
        numbers = numbers_of(word, sources)
        found.update(numbers)
        if not numbers:
            lost.append(word)
    return [f"@index={k}" for k in sorted(found)] + asked, lost


def paths_of(numbers, sources):
    """Paths that name these parts and no others: of an assembly all whose parts are meant its own."""
    wanted, paths = set(numbers), []
    while wanted:
        path = sources[min(wanted)]
        below = numbers_of_path(path, sources)
        names = path.split(".")
        for depth in range(1, len(names)):
            above = numbers_of_path(".".join(names[:depth]), sources)
            if set(above) <= wanted and len(above) < len(sources):
                path, below = ".".join(names[:depth]), above
                break
        paths.append(path)
        wanted -= set(below)
    return paths


def numbers_of_path(path, sources):
    """Numbers of the parts at a path and below it."""
    return [k for k, source in enumerate(sources) if f"{source}.".startswith(f"{path}.")]
