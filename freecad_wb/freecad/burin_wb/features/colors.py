"""Colours of parts as the 3-D view shows them, with what is seen through them. Only a GUI has them."""


def colors_of(top, sub, leaf):
    """'#rrggbb', of glass '#rrggbbaa', of the object at `sub` ('Inner.Link.') below `top`: that of the outermost link that
    has a colour of its own, else of the shape `leaf` itself; empty where its faces have several. With it those of the
    faces in turn, where they have several."""
    for link, element in _links(top, sub):
        color = _override(getattr(link, "ViewObject", None), element)
        if color:
            return color, ()
    obj = top.getSubObject(sub, retType=1) if sub else top
    for candidate in (obj, leaf):
        view = getattr(candidate, "ViewObject", None)
        if view is not None:
            colors = appearance(view)
            alike = len(set(colors)) == 1
            return (colors[0], ()) if alike else ("", colors)
    return "", ()


def _links(top, sub):
    """The links on the way to an object, from the outermost on, each with the number of its element where it is an array
    whose elements are no objects (else -1)."""
    names = sub.rstrip(".").split(".") if sub else []
    seen = set()
    for k in range(len(names) + 1):
        link = top.getSubObject(".".join(names[:k]) + ".", retType=1) if k else top
        element = int(names[k]) if k < len(names) and names[k].isdigit() else -1
        while link is not None and (link.isDerivedFrom("App::Link") or link.isDerivedFrom("App::LinkElement")):
            if link.FullName not in seen:
                seen.add(link.FullName)
                yield link, element
            linked, element = link.getLinkedObject(False), -1
            link = linked if linked is not link else None


def _override(view, element):
    """The colour that a link gives to what it links to; empty where it gives none."""
    if getattr(view, "OverrideMaterial", False):
        return _of_material(view.ShapeMaterial)
    chosen = getattr(view, "OverrideMaterialList", ())
    if 0 <= element < len(chosen) and chosen[element]:
        return _of_material(view.MaterialList[element])
    return ""


def appearance(view):
    """The colours of a view provider, of FreeCAD 1.x (ShapeAppearance) or before: one, or one a face."""
    materials = getattr(view, "ShapeAppearance", None)
    if materials:
        return tuple(_of_material(m) for m in materials)
    faces = getattr(view, "DiffuseColor", None)
    if faces:  # their fourth number is transparency
        return tuple(_hex(c, c[3] if len(c) > 3 else 0) for c in faces)
    color = getattr(view, "ShapeColor", None)
    return (_hex(color, getattr(view, "Transparency", 0) / 100),) if color else ()


def split(color):
    """'#rrggbb' and the opacity, 0 to 1, of a colour as `colors_of` gives it."""
    return color[:7], int(color[7:], 16) / 255 if len(color) > 7 else 1.0


def _of_material(material):
    return _hex(material.DiffuseColor, getattr(material, "Transparency", 0))


def _hex(color, transparency):
    opacity = round(255 * (1 - min(max(transparency, 0.0), 1.0)))
    return "#%02x%02x%02x" % tuple(round(255 * c) for c in color[:3]) + ("%02x" % opacity if opacity < 255 else "")
