"""From an empty document to a PDF: an engraved assembly on an A3 page. Told with pictures in README.md; run by the tests.

In FreeCAD (with its window): exec(open("bearing.py").read()); page = whole("bearing.pdf")"""

import FreeCAD
import Part

V = FreeCAD.Vector


def assembly(document):
    """A pillow block with its shaft, ring and two bolts, as an App::Part."""
    base = Part.makeBox(120, 40, 14, V(-60, -20, 0)).fuse(Part.makeBox(60, 40, 34, V(-30, -20, 0)))
    base = base.fuse(Part.makeCylinder(30, 40, V(0, -20, 34), V(0, 1, 0)))
    base = base.cut(Part.makeCylinder(22, 40, V(0, -20, 34), V(0, 1, 0)))
    for x in (-45, 45):
        base = base.cut(Part.makeCylinder(5, 14, V(x, 0, 0)))
    ring = Part.makeCylinder(22, 40, V(0, -20, 34), V(0, 1, 0)).cut(Part.makeCylinder(14, 40, V(0, -20, 34), V(0, 1, 0)))
    shaft = Part.makeCylinder(14, 110, V(0, -75, 34), V(0, 1, 0))
    shaft = shaft.fuse(Part.makeCone(11, 14, 4, V(0, -79, 34), V(0, 1, 0)))
    bolt = Part.makeCylinder(4.8, 26, V(0, 0, -6)).fuse(_hexagon(9, 7, 14))

    part = document.addObject("App::Part", "Bearing")
    for name, shape, x in (("Block", base.removeSplitter(), 0), ("Ring", ring, 0), ("Shaft", shaft, 0),
                           ("Bolt", bolt, -45), ("Bolt", bolt, 45)):
        feature = document.addObject("Part::Feature", name)
        feature.Shape = shape
        feature.Placement.Base = V(x, 0, 0)
        part.addObject(feature)
    document.recompute()
    return part


def _hexagon(radius, height, z):
    import math

    corners = [V(radius * math.cos(k * math.pi / 3), radius * math.sin(k * math.pi / 3), z) for k in range(7)]
    return Part.Face(Part.makePolygon(corners)).extrude(V(0, 0, height))


def illustration(document, part):
    """The assembly engraved, 360 x 250 mm on paper."""
    from freecad.burin_wb.features import make_illustration

    obj = make_illustration(document, [part])
    obj.Style = "engraving"
    obj.Width, obj.Height = 360, 250
    obj.ViewDirection = V(1, -1.6, 1.1)
    return obj


def wait():
    """With a window runs go on beside it: let them end."""
    if FreeCAD.GuiUp:
        from freecad.burin_wb.view import scheduler

        scheduler.wait()


def page_with(document, obj):
    """An A3 page with the illustration at its own scale."""
    from freecad.burin_wb.features import place_on_page
    from freecad.burin_wb.features.sheet_view import blank_template

    page = document.addObject("TechDraw::DrawPage", "Page")
    template = document.addObject("TechDraw::DrawSVGTemplate", "Template")
    template.Template = blank_template([(390, 270)])  # the smallest of FreeCAD's that holds this, A3, wherever this version has it
    page.Template = template
    place_on_page(page, obj)
    document.recompute()
    return page


def whole(pdf):
    """All of it; returns the page."""
    document = FreeCAD.newDocument("Bearing")
    obj = illustration(document, assembly(document))
    document.recompute()
    wait()
    page = page_with(document, obj)
    page.ViewObject.show()  # TechDraw exports pages that have been shown
    import FreeCADGui
    import TechDrawGui

    FreeCADGui.updateGui()
    TechDrawGui.exportPageAsPdf(page, pdf)
    return page
