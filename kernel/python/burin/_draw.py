"""`draw` with its keywords spelled out, so that `help`, `inspect` and editors show them."""

from ._burin import draw as _draw


def draw(
    source,
    *,
    view="iso",
    up=None,
    perspective=None,
    paper="A4",
    scale=None,
    margin=10,
    style="technical",
    set=None,
    light=None,
    hidden="none",
    tolerance=None,
    bounds=None,
    seed=1,
    threads=None,
    center=None,
    verify=False,
    id_prefix="",
    field=None,
    tone=None,
    progress=None,
    cancel=None,
    mesher=None,
    define=None,
    openscad_timeout=None,
    object=None,
    recompute=None,
    freecad_timeout=None,
    heal=None,
    iso=None,
    inside=None,
    smooth=None,
    specks=None,
    volume_degree=None,
    interpolate=None,
    raw=None,
    raw_skip=None,
    **unknown,
):
    """Draws a scene, a file or several files. Arguments are the long options of `burin draw`.

    `style` as a mapping is that of a style file ({"base": "engraving", "line.outer": 0.5}); `set` overrides
    single keys, or groups of them ({"hatch": {"taper": 1}}). `paper` is a name, (width, height) in mm or "fit";
    `margin` one number or (top, right, bottom, left). `center`: the model point in the middle of the sheet, with
    `scale`; absent = the middle of what is drawn. `field` and `tone` are called with positions (n, 3) in mm and
    unit normals (n, 3), from the thread that called: `field` gives directions (n, 3), whose tangent parts strokes
    follow (NaN = none here), `tone` the wanted darkness (n,) in [0, 1]. Arguments from `mesher` on, and `bounds`,
    are about reading files; for a scene they go to `Scene.read`. The GIL is released while the kernel works.
    Throws Error.
    """
    reading = {
        "mesher": mesher,
        "define": define,
        "openscad_timeout": openscad_timeout,
        "object": object,
        "recompute": recompute,
        "freecad_timeout": freecad_timeout,
        "heal": heal,
        "iso": iso,
        "inside": inside,
        "smooth": smooth,
        "specks": specks,
        "volume_degree": volume_degree,
        "interpolate": interpolate,
        "raw": raw,
        "raw_skip": raw_skip,
    }
    unknown.update((name, value) for name, value in reading.items() if value is not None)
    return _draw(
        source,
        view=view,
        up=up,
        perspective=perspective,
        paper=paper,
        scale=scale,
        margin=margin,
        style=style,
        set=set,
        light=light,
        hidden=hidden,
        tolerance=tolerance,
        bounds=bounds,
        seed=seed,
        threads=threads,
        center=center,
        verify=verify,
        id_prefix=id_prefix,
        field=field,
        tone=tone,
        progress=progress,
        cancel=cancel,
        **unknown,
    )


draw.__module__ = "burin"
