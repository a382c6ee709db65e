"""Colours as FreeCAD 1.x keeps them, which is not here: its view providers are played."""

from types import SimpleNamespace

from support import Case

from freecad.burin_wb.features.colors import appearance


def material(*color):
    return SimpleNamespace(DiffuseColor=color)


class Colors(Case):
    def test_the_appearance_of_freecad_1(self):
        red, blue = material(1.0, 0.0, 0.0, 1.0), material(0.0, 0.0, 1.0, 1.0)
        view = SimpleNamespace(ShapeAppearance=(red,), ShapeColor=(0.0, 1.0, 0.0, 0.0))
        self.assertEqual(appearance(view), "#ff0000")
        view.ShapeAppearance = (blue, blue, blue)
        self.assertEqual(appearance(view), "#0000ff")
        view.ShapeAppearance = (blue, red)
        self.assertEqual(appearance(view), "")

    def test_the_colours_of_freecad_before(self):
        self.assertEqual(appearance(SimpleNamespace(ShapeColor=(0.0, 1.0, 0.0, 0.0))), "#00ff00")
        self.assertEqual(appearance(SimpleNamespace(ShapeColor=(0.0, 1.0, 0.0), DiffuseColor=[(1.0, 0.0, 0.0)])), "#ff0000")
        self.assertEqual(appearance(SimpleNamespace()), "")
