"""Colours as FreeCAD 1.x keeps them, which is not here: its view providers are played."""

from types import SimpleNamespace

from support import Case

from freecad.burin_wb.features.colors import appearance, colors_of, split


def material(*color, transparency=0.0):
    return SimpleNamespace(DiffuseColor=color, Transparency=transparency)


class Colors(Case):
    def test_the_appearance_of_freecad_1(self):
        red, blue = material(1.0, 0.0, 0.0, 1.0), material(0.0, 0.0, 1.0, 1.0)
        view = SimpleNamespace(ShapeAppearance=(red,), ShapeColor=(0.0, 1.0, 0.0, 0.0))
        self.assertEqual(appearance(view), ("#ff0000",))
        view.ShapeAppearance = (blue, blue, blue)
        self.assertEqual(appearance(view), ("#0000ff",) * 3)
        view.ShapeAppearance = (blue, red)
        self.assertEqual(appearance(view), ("#0000ff", "#ff0000"))

    def test_what_is_seen_through(self):
        view = SimpleNamespace(ShapeAppearance=(material(1.0, 0.0, 0.0, 1.0, transparency=0.6),))
        self.assertEqual(appearance(view), ("#ff000066",))
        view.ShapeAppearance += (material(1.0, 0.0, 0.0, 1.0),)
        self.assertEqual(appearance(view), ("#ff000066", "#ff0000"))
        self.assertEqual(appearance(SimpleNamespace(ShapeColor=(0.0, 1.0, 0.0, 0.0), Transparency=60)), ("#00ff0066",))
        link = SimpleNamespace(FullName="a#Link", ViewObject=SimpleNamespace(
            OverrideMaterial=True, ShapeMaterial=material(0.0, 0.0, 1.0, 0.0, transparency=0.6)),
            isDerivedFrom=lambda kind: kind == "App::Link", getLinkedObject=lambda deep: link)
        self.assertEqual(colors_of(link, "", None), ("#0000ff66", ()))
        self.assertEqual(split("#0000ff66"), ("#0000ff", 0.4))
        self.assertEqual(split("#0000ff"), ("#0000ff", 1.0))
        self.assertEqual(split(""), ("", 1.0))

    def test_the_colours_of_freecad_before(self):
        self.assertEqual(appearance(SimpleNamespace(ShapeColor=(0.0, 1.0, 0.0, 0.0))), ("#00ff00",))
        self.assertEqual(appearance(SimpleNamespace(ShapeColor=(0.0, 1.0, 0.0), DiffuseColor=[(1.0, 0.0, 0.0)])), ("#ff0000",))
        self.assertEqual(appearance(SimpleNamespace()), ())

    def test_faces_have_several(self):
        gold, green = (1.0, 0.84, 0.0, 0.0), (0.0, 0.5, 0.0, 0.0)
        board = SimpleNamespace(ViewObject=SimpleNamespace(DiffuseColor=[green, gold]), FullName="a#Board",
                                isDerivedFrom=lambda kind: False)
        self.assertEqual(colors_of(board, "", board), ("", ("#008000", "#ffd600")))
        glass = (0.0, 0.5, 0.0, 0.6)  # FreeCAD 0.20: how transparent a face is
        board.ViewObject.DiffuseColor = [glass, gold]
        self.assertEqual(colors_of(board, "", board), ("", ("#00800066", "#ffd600")))
        board.ViewObject.DiffuseColor = [gold, gold]
        self.assertEqual(colors_of(board, "", board), ("#ffd600", ()))
