"""What FreeCAD 1.0's workbench Assembly keeps of an exploded view, as far as it is read; that version could not be tried here."""

import FreeCAD

V = FreeCAD.Vector


class ExplodedView:
    """The Proxy has no say in it."""

    def __init__(self, obj):
        obj.Proxy = self


def exploded_view(document, assembly, in_group=True):
    """Bolts and lid, then one move that turns and one away from a middle. `in_group`: as in FreeCAD 1.1; else as in 1.0."""
    view = document.addObject("App::FeaturePython", "Exploded_View")
    ExplodedView(view)
    moves = [_move(document, assembly, "Move", ["Bolt.", "Bolt001.Face1"], V(0, 0, 50)), _move(document, assembly, "Move", ["Lid"], V(0, 30, 0)),
             _move(document, assembly, "Turned", ["Lid."], V(0, 0, 5), FreeCAD.Rotation(V(0, 0, 1), 30)),
             _move(document, assembly, "Round", ["Lid."], V(0, 0, 5), kind="Radial")]
    name = "Group" if in_group else "Moves"
    view.addProperty("App::PropertyLinkListHidden", name, "Exploded View")
    setattr(view, name, moves)
    return view


def _move(document, assembly, name, subs, base, rotation=FreeCAD.Rotation(), kind="Normal"):
    move = document.addObject("App::FeaturePython", name)
    move.addProperty("App::PropertyXLinkSub", "References", "Exploded Move")
    move.References = assembly, subs
    move.addProperty("App::PropertyPlacement", "MovementTransform", "Exploded Move")
    move.MovementTransform = FreeCAD.Placement(base, rotation)
    move.addProperty("App::PropertyEnumeration", "MoveType", "Exploded Move")
    move.MoveType = ["Normal", "Radial"]
    move.MoveType = kind
    return move
