"""From a STEP file to an exploded, numbered, engraved picture with its parts list on an A3 page, a section of the same pump, with a detail
too, and its step book. Told with pictures in README.md; run by the tests.

In FreeCAD (with its window), in this folder: exec(open("gear_pump.py").read())
pages = whole("gear_pump.step", "pump.pdf", "section.pdf", "detail.pdf"); book(pages[0].Views[0].Illustration, "steps.pdf")"""

import os

import FreeCAD

V = FreeCAD.Vector


def assembly(document, file):
    """The assembly of a STEP file, taken in as one, which FreeCAD's preferences may not have it do by themselves."""
    import Import

    Import.insert(file, document.Name, merge=False, useLinkGroup=True)
    document.recompute()
    return next(o for o in document.Objects if o.Label == "gear pump" and not o.InList)


def paths(part, *labels, path=""):
    """Paths of the objects in an assembly whose labels begin so: releases of FreeCAD give them other names, and arrays in place of
    single links."""
    for sub in part.getSubObjects():
        obj, here = part.getSubObject(sub, retType=1), f"{path or part.Name}.{sub.rstrip('.')}"
        if obj.Label.startswith(labels):
            yield here
        else:
            yield from paths(obj, *labels, path=here)


def exploded(document, part):
    """The pump taken apart and numbered, with its list, engraved, 390 x 270 mm on paper."""
    from freecad.burin_wb.features import asking, explosion, make_illustration

    obj = make_illustration(document, [part], "Exploded")
    obj.Style = "engraving"
    obj.Width, obj.Height = 390, 270
    obj.ViewDirection, obj.ViewUp = V(1, -1.2, 0.8), V(0, 1, 0)
    steps, _ = asking.find_steps(obj)
    explosion.set_steps(obj, steps)
    obj.Explode = obj.Callouts = obj.PartsList = True
    return obj


def cut(document, part):
    """The pump cut in the middle; shafts, keys and pins stay whole."""
    from freecad.burin_wb.features import make_illustration, section

    obj = make_illustration(document, [part], "Cut")
    obj.Style = "engraving"
    obj.Width, obj.Height = 270, 180
    obj.ViewDirection = V(0.5, -1, 0.6)
    whole = list(paths(part, "drive shaft", "idler shaft", "key", "dowel"))
    obj.Sections = [section.text_of(section.plane((0, -1, 0), 0, whole))]
    return obj


def dowel(part):
    """The path of the first of the two dowels."""
    path = next(paths(part, "dowel"))
    elements = part.getSubObject(path.partition(".")[2] + ".", retType=1).getSubObjects()
    return f"{path}.{elements[0].rstrip('.')}" if elements else path


def detailed(document, part):
    """The section with a dowel again, four times as large as it is, and 9 mm around its middle."""
    from freecad.burin_wb.features import details

    obj = cut(document, part)
    obj.Label = "Detailed"
    details.set_details(obj, [{**details.of_objects([dowel(part)], "4:1"), "radius": 9.0}])
    return obj


def book(obj, file):
    """How an illustrated assembly is put together, a page a step; how many there are."""
    from freecad.burin_wb import step_book

    return step_book.write(obj, file)


def page(document, obj):
    """An A3 page with an illustration at its own scale."""
    from bearing import page_with

    return page_with(document, obj)


def whole(file, *pdfs):
    """All of it; returns the pages, of the exploded pump, of the section and of that with a detail."""
    from bearing import wait

    document = FreeCAD.newDocument("GearPump")
    part = assembly(document, os.path.abspath(file))
    pages = []
    for make, pdf in zip((exploded, cut, detailed), pdfs):
        obj = make(document, part)
        document.recompute()
        wait()
        pages.append(page(document, obj))
        pages[-1].ViewObject.show()  # TechDraw exports pages that have been shown
        import FreeCADGui
        import TechDrawGui

        FreeCADGui.updateGui()
        TechDrawGui.exportPageAsPdf(pages[-1], pdf)
    return pages
