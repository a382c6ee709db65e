"""The words that say how single objects are drawn, as the property Looks keeps them."""

FLAGS = ("not drawn", "not hatched", "transparent")


def path_of(top, sub=""):
    """An object's key in Looks: 'Assembly.Body' with the internal names; elements do not count."""
    names = sub[: sub.rfind(".") + 1].rstrip(".")
    return top.Name + ("." + names if names else "")


def words_of(text):
    return [w.strip() for w in text.split(";") if w.strip()]


def flags_of(text):
    return {w for w in words_of(text) if w in FLAGS}


def style_of(text):
    """The style of an object's own; empty where it has none."""
    return next((w[len("style="):] for w in words_of(text) if w.startswith("style=")), "")


def with_flag(text, flag, on):
    words = [w for w in words_of(text) if w != flag]
    return ";".join(words + [flag] if on else words)


def with_style(text, style):
    words = [w for w in words_of(text) if not w.startswith("style=")]
    return ";".join(words + ["style=" + style] if style else words)
