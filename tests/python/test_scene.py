"""Scenes: from files, from BREP text, from arrays and from functions."""

import errno
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import burin
import numpy as np
from support import PLATE, SAMPLES, cube


class Files(unittest.TestCase):
    def test_parts_of_several_files_in_order(self):
        scene = burin.Scene.read(SAMPLES / "spindle.stl", str(SAMPLES / "bolt.3mf"))
        names = [part.name for part in scene.parts]
        self.assertEqual(names[0], "spindle")
        self.assertEqual(scene.parts[0].source, str(SAMPLES / "spindle.stl"))
        self.assertGreaterEqual(len(names), 2)

    def test_cad_file_has_assembly(self):
        scene = burin.Scene.read(SAMPLES / "coupling.step")
        self.assertGreater(len(scene.parts), 1)
        self.assertTrue(all(part.assembly for part in scene.parts))

    def test_annotations_of_a_step_file(self):
        lines = """#90001=DRAUGHTING_CALLOUT('Size.1',(#90002));
#90002=TESSELLATED_ANNOTATION_OCCURRENCE('',(),#90003);
#90003=TESSELLATED_CURVE_SET('',#90004,((1,2,3,1)));
#90004=COORDINATES_LIST('',3,((0.,0.,0.),(9.,0.,0.),(9.,9.,0.)));
#90005=SHAPE_ASPECT('','',#4,.T.);
#90006=FLATNESS_TOLERANCE('Flat.1','',#90007,#90005);
#90007=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.2),#4458);
#90008=DRAUGHTING_MODEL_ITEM_ASSOCIATION('','',#90006,#90001,#90001);
"""
        head, end, tail = (SAMPLES / "pedestal.step").read_text().rpartition("ENDSEC;")
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "bearing.step")
            path.write_text(head + lines + end + tail)
            self.assertEqual(burin.Scene.read(path).pmi, [])
            (item,) = burin.Scene.read(path, pmi=True).pmi
        self.assertEqual((item["kind"], item["text"], item["value"], item["part"]), ("tolerance", "flatness 0.2", 0.2, 0))
        self.assertEqual([line.tolist() for line in item["lines"]], [[[0, 0, 0], [9, 0, 0], [9, 9, 0], [0, 0, 0]]])
        self.assertEqual(item["filled"], [])

    def test_bounds_of_a_function(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "half.implicit")
            path.write_text("sphere(5)")
            scene = burin.Scene.read(path, bounds=[-6, -6, -6, 6, 6, 0])
        np.testing.assert_allclose(scene.bounds(), [[-5, -5, -5], [5, 5, 0]], atol=0.05)

    def test_messages_name_arguments_not_options_of_the_command(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "half.implicit")
            path.write_text("z")
            with self.assertRaisesRegex(burin.InputError, "give its domain by bounds=x0,y0,z0,x1,y1,z1$"):
                burin.Scene.read(path)
            box = [-6, -6, -6, 6, 6, 6]
            clipped = "can be given by bounds$"
            self.assertRegex(burin.draw(path, style="outline", bounds=box).diagnostics[0].message, clipped)
            [told] = burin.info(path, bounds=box)
            self.assertRegex(told["diagnostics"][0]["message"], clipped)
        with self.assertRaisesRegex(burin.UsageError, r"all: burin\.style_keys\(\)\)$"):
            burin.draw(SAMPLES / "bracket.off", set={"line.outr": 1})

    def test_a_missing_file_is_a_file_not_found_error(self):
        for call in (burin.Scene.read, burin.draw, burin.info, burin.Drawing.load):
            with self.assertRaises(FileNotFoundError) as caught:
                call("/no/such/part.step")
            error = caught.exception
            self.assertIsInstance(error, burin.MissingFile)
            self.assertIsInstance(error, burin.InputError)
            self.assertEqual((error.file, error.line, error.errno), ("/no/such/part.step", 0, errno.ENOENT))
            self.assertIn("/no/such/part.step: ", str(error))
        with self.assertRaises(FileNotFoundError):
            burin.draw(burin.Scene(), style="/no/such/style.json")
        with self.assertRaises(burin.InputError) as caught:
            burin.Scene.read(SAMPLES)
        self.assertNotIsInstance(caught.exception, FileNotFoundError)

    def test_missing_file(self):
        with self.assertRaises(burin.InputError) as caught:
            burin.Scene.read("/nowhere/part.stl")
        self.assertEqual(caught.exception.file, "/nowhere/part.stl")
        self.assertEqual(caught.exception.line, 0)
        self.assertIn("/nowhere/part.stl: there is no such file", str(caught.exception))

    def test_broken_file_names_its_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "broken.obj")
            path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 zero\nf 1 2 3\n")
            with self.assertRaises(burin.InputError) as caught:
                burin.Scene.read(path)
        self.assertEqual((caught.exception.file, caught.exception.line), (str(path), 3))

    def test_unknown_option_names_the_nearest(self):
        with self.assertRaisesRegex(burin.UsageError, "'bonds'.*'bounds'"):
            burin.Scene.read(SAMPLES / "spindle.stl", bonds=[0, 0, 0, 1, 1, 1])

    def test_options_are_judged_as_on_the_command_line(self):
        with self.assertRaisesRegex(burin.UsageError, "argument bounds takes a box"):
            burin.Scene.read(SAMPLES / "blend.implicit", bounds=[0, 0, 0, 1, 1])


    def test_bounds_may_be_those_of_a_scene(self):
        whole = burin.Scene.read(SAMPLES / "blend.implicit")
        half = whole.bounds()
        half[1, 2] = 0
        scene = burin.Scene.read(SAMPLES / "blend.implicit", bounds=half)
        np.testing.assert_allclose(scene.bounds()[1, 2], 0, atol=1e-6)

    def test_flags_take_booleans_of_numpy(self):
        scene = burin.Scene.read(SAMPLES / "spindle.stl", heal=np.bool_(False))
        self.assertEqual(len(scene), 1)
        with self.assertRaisesRegex(burin.UsageError, "argument heal takes true or false"):
            burin.Scene.read(SAMPLES / "spindle.stl", heal="perhaps")


class Mistakes(unittest.TestCase):
    """One line each, with the argument."""

    BOX = (-1, -1, -1, 1, 1, 1)

    def test_wrong_types(self):
        scene = burin.Scene()
        with self.assertRaisesRegex(TypeError, "^argument cancel takes a Cancel$"):
            burin.draw(SAMPLES / "bracket.off", cancel=True)
        with self.assertRaisesRegex(TypeError, "^argument cancel takes a Cancel$"):
            burin.Scene.read(SAMPLES / "bracket.off", cancel=3)
        with self.assertRaisesRegex(TypeError, "^argument assembly takes a list of names$"):
            scene.add_mesh(*cube(), assembly="pump")
        self.assertEqual(len(scene), 0)

    def test_functions_without_a_surface(self):
        scene = burin.Scene()
        for values, message in [
            (lambda p: 0 * p[:, 0] + 1, "nowhere negative"),
            (lambda p: 0 * p[:, 0] - 1, "negative everywhere"),
            (lambda p: np.nan * p[:, 0], "no finite number"),
        ]:
            with self.assertRaisesRegex(burin.GeometryError, message):
                scene.add_function(values, self.BOX, samples=16)


class Colours(unittest.TestCase):
    def test_are_judged_when_they_are_given(self):
        scene = burin.Scene()
        part = scene.add_mesh(*cube(), "lid", color="Orange")
        self.assertEqual(part.color, "#f28e2b")
        part.color = "#123456"
        self.assertEqual(part.color, "#123456")
        for wrong in ("zzz", "#ffff", "#12345678"):
            with self.assertRaisesRegex(burin.UsageError, "color of a part .* not '" + wrong):
                part.color = wrong
            with self.assertRaisesRegex(burin.UsageError, "not '" + wrong):
                scene.add_mesh(*cube(), "lid", color=wrong)
        with self.assertRaisesRegex(burin.UsageError, "opacity of a part is 0 to 1, not 7"):
            part.opacity = 7
        self.assertEqual((part.color, part.opacity, len(scene.parts)), ("#123456", 1.0, 1))

    def test_of_a_part_are_those_of_its_faces_too(self):
        scene = burin.Scene()
        part = scene.add_brep(PLATE, face_colors=["#ff0000", "#0000ff"] * 3 + ["#ff0000"])
        style = {**burin.style("flat")}
        fills = lambda: {area["fill"] for area in burin.draw(scene, style=style).areas}  # noqa: E731
        self.assertGreater(len(fills()), 1)
        part.color = "#7090b0"
        self.assertEqual(fills(), {"#7090b0"})

    def test_of_glass_have_an_opacity(self):
        scene = burin.Scene()
        part = scene.add_brep(PLATE, face_colors=["#80c0ff66"] * 7)
        self.assertEqual(part.color, "#80c0ff")
        self.assertAlmostEqual(part.opacity, 0.4)
        self.assertEqual(scene.add_brep(PLATE, face_colors=["#80c0ff66"] + [""] * 6, color="#808080").opacity, 1)
        with self.assertRaisesRegex(burin.UsageError, "#rrggbb or #rrggbbaa, not '#80c0f'"):
            scene.add_brep(PLATE, face_colors=["#80c0f"] * 7)


class Joined(unittest.TestCase):
    def test_a_part_of_two_looks_is_counted_once(self):
        def scene_of(joined):
            scene = burin.Scene()
            for kind, (height, look) in enumerate([(10, "#102030"), (14, "#ff0000")] * 2):
                vertices, triangles = cube()
                shift = [40 * (kind // 2), 0, 10 * (kind % 2)]
                part = scene.add_mesh(vertices * [1, 1, height / 10] + shift, triangles, name="knob", color=look)
                self.assertIs(part.joined, False)
                part.joined = joined and kind % 2 == 1
            return scene

        self.assertEqual([item["quantity"] for item in burin.items(scene_of(True))], [2])
        self.assertEqual([item["quantity"] for item in burin.items(scene_of(False))], [2, 2])


class Threads(unittest.TestCase):
    """PLATE has a bore of 10 mm at 10, 10: of a thread of 12 mm with a pitch of 2."""

    thread = {"size": "M12x2", "at": (10, 10, 10), "along": (0, 0, -2), "length": 6}

    def plate(self):
        scene = burin.Scene()
        scene.add_brep(PLATE, "plate")
        return scene

    def arcs(self, scene, **keys):
        drawing = burin.draw(scene, style="outline", view="top", **keys)
        return [path for layer in drawing.layers if layer.name == "thread" for path in layer.paths]

    def test_of_a_part_are_drawn_on_its_cylinder(self):
        scene = self.plate()
        self.assertEqual(scene.parts[0].threads, [])
        scene.parts[0].threads = [self.thread]
        [told] = scene.parts[0].threads
        self.assertEqual((told["size"], told["along"], told["length"], told["internal"]), ("M12x2", (0, 0, -1), 6, True))
        scene.parts[0].threads = [told]  # as it was given back
        [arc] = self.arcs(scene)
        np.testing.assert_allclose(np.hypot(arc.points3[:, 0] - 10, arc.points3[:, 1] - 10), 6, atol=1e-6)
        self.assertEqual(self.arcs(scene, set={"feature.threads": False}), [])

    def test_of_illustrations_and_keywords(self):
        for keys in ({"thread": "plate=M12x2"}, {"illustration": {"threads": [{"select": "plate", "size": "M12x2"}]}}):
            self.assertEqual(len(self.arcs(self.plate(), **keys)), 1, keys)

    def test_what_is_no_thread_is_refused(self):
        part = self.plate().parts[0]
        for wrong, why in (({"size": "12"}, "not '12'"), ({"length": 0}, "over 0"), ({"along": (0, 0, 0)}, "direction"),
                           ({"at": (1, 2)}, "three numbers"), ({"wide": 1}, 'no key "wide"')):
            with self.assertRaisesRegex(burin.UsageError, why):
                part.threads = [{**self.thread, **wrong}]
        with self.assertRaisesRegex(burin.UsageError, "mapping"):
            part.threads = ["M12x2"]


class Brep(unittest.TestCase):
    def test_faces_and_edges_are_numbered_as_in_the_shape(self):
        scene = burin.Scene()
        part = scene.add_brep(PLATE, "plate", color="#102030", assembly=["pump"], source="Plate")
        self.assertEqual((part.name, part.color, part.source), ("plate", "#102030", "Plate"))
        self.assertEqual(part.assembly, ["pump"])
        np.testing.assert_allclose(scene.bounds(), [[0, 0, 0], [30, 20, 10]], atol=1e-9)
        drawing = burin.draw(scene, style="outline", hidden="dashed")
        self.assertEqual(drawing.parts[0]["faces"], 7)
        paths = [path for layer in drawing.layers for path in layer.paths]
        # TopExp's order: the twelve edges of the box, the two circles, and last the seam, no line.
        self.assertEqual({path.edge for path in paths} - {-1}, set(range(14)))
        circles = set()
        for path in paths:
            radius = np.hypot(path.points3[:, 0] - 10, path.points3[:, 1] - 10)
            if path.edge >= 0 and len(path) > 4 and abs(radius - 5).max() < 0.01:
                circles.add(path.edge)
        self.assertEqual(circles, {9, 13})

    def test_placement(self):
        turn = np.array([[0, -1, 0, 100], [1, 0, 0, 0], [0, 0, 1, -5], [0, 0, 0, 1.0]])
        scene = burin.Scene()
        scene.add_brep(PLATE.encode(), placement=turn)
        np.testing.assert_allclose(scene.bounds(), [[80, 0, -5], [100, 30, 5]], atol=1e-9)

    def test_placement_that_stretches_shears_and_mirrors(self):
        for linear in (np.diag([2, 2, 2.0]), np.diag([1, -3, 1.0]), np.array([[1, 0.5, 0], [0, 1, 0.2], [0, 0, 4.0]])):
            matrix = np.eye(4)
            matrix[:3, :3] = linear
            scene, whole = burin.Scene(), burin.Scene()
            whole.add_brep(PLATE)
            scene.add_brep(PLATE, placement=matrix)
            low, high = np.array(whole.bounds())
            corners = np.array([[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])])
            placed = corners @ linear.T
            np.testing.assert_allclose(scene.bounds(), [placed.min(axis=0), placed.max(axis=0)], atol=1e-6)
            drawing = burin.draw(scene, style="outline", paper="A6")
            self.assertGreater(sum(len(layer.paths) for layer in drawing.layers), 5)
            self.assertFalse(drawing.diagnostics)

    def test_placement_that_is_none(self):
        flat = np.diag([1, 1, 0, 1.0])
        for matrix in (flat, np.eye(3), np.full((4, 4), np.nan), np.eye(4) * 2):
            with self.assertRaisesRegex(burin.UsageError, "placement"):
                burin.Scene().add_brep(PLATE, placement=matrix)

    def test_one_shape_in_many_places(self):
        shape = burin.Brep(PLATE)
        self.assertTrue(shape.is_valid())
        places = [np.eye(4) for _ in range(3)]
        for k, place in enumerate(places):
            place[:3, 3] = (40 * k, 5 * k, -3 * k)
        shared, apart = burin.Scene(), burin.Scene()
        for place in places:
            shared.add_brep(shape, "plate", placement=place)
            apart.add_brep(PLATE, "plate", placement=place)
        draw = lambda scene: burin.draw(scene, style="technical", paper="A6").to_bytes("json")  # noqa: E731
        self.assertEqual(draw(shared), draw(apart))
        with self.assertRaises(burin.InputError):
            burin.Brep("garbage")

    def test_a_shape_with_a_fault(self):
        # One end of an edge moved off its curve by half a millimetre.
        moved = PLATE.replace("\n30 20 10\n", "\n30 20 10.5\n")
        self.assertNotEqual(moved, PLATE)
        self.assertFalse(burin.Brep(moved).is_valid())

    def test_garbage(self):
        for text in ("", "garbage", PLATE[: len(PLATE) // 2], PLATE.replace("1 0 0", "x", 1)):
            with self.assertRaises(burin.InputError):
                burin.Scene().add_brep(text)
        with self.assertRaises(TypeError):
            burin.Scene().add_brep(3)

    def test_a_failed_part_leaves_the_scene_as_it_was(self):
        scene = burin.Scene()
        scene.add_brep(PLATE)
        with self.assertRaises(burin.InputError):
            scene.add_brep("garbage")
        self.assertEqual(len(scene.parts), 1)


class Mesh(unittest.TestCase):
    def test_types_of_arrays(self):
        vertices, triangles = cube()
        for positions in (vertices, vertices.astype("f4"), vertices.tolist(), np.asfortranarray(vertices)):
            for corners in (triangles, triangles.astype("u1"), triangles.astype(">i4"), triangles.tolist()):
                scene = burin.Scene()
                scene.add_mesh(positions, corners)
                np.testing.assert_array_equal(scene.bounds(), [[0, 0, 0], [10, 10, 10]])
                self.assertEqual(scene.diagnostics, [])

    def test_repair_is_told(self):
        vertices, triangles = cube()
        scene = burin.Scene()
        scene.add_mesh(vertices, np.vstack([triangles, [[0, 1, 3]]]))
        self.assertEqual([d.code for d in scene.diagnostics], ["mesh.duplicate_faces"])
        self.assertEqual(scene.diagnostics[0].count, 1)
        self.assertIn(scene.diagnostics[0].severity, ("info", "warning"))

    def test_vertices_that_are_not_numbers_are_left_out(self):
        vertices, triangles = cube()
        vertices[7] = np.nan
        scene = burin.Scene()
        scene.add_mesh(vertices, triangles)
        self.assertTrue(scene.diagnostics)
        self.assertTrue(np.isfinite(scene.bounds()).all())

    def test_bad_arrays(self):
        vertices, triangles = cube()
        bad = [
            (vertices[:, :2], triangles, r"vertices.*\(n, 3\).*\(8, 2\)"),
            (vertices.ravel(), triangles, "vertices"),
            ("text", triangles, "vertices"),
            (vertices, triangles[:, :2], r"triangles.*\(m, 3\)"),
            (vertices, triangles.astype(float), "triangles.*whole numbers.*float64"),
            (vertices, triangles + 1, "corner .* is 8; there are 8 vertices"),
            (vertices, triangles - 1, "is -1"),
        ]
        for v, t, message in bad:
            with self.assertRaisesRegex(burin.UsageError, message):
                burin.Scene().add_mesh(v, t)

    def test_empty(self):
        with self.assertRaises(burin.GeometryError):
            burin.Scene().add_mesh(np.zeros((0, 3)), np.zeros((0, 3), int))
        with self.assertRaises(burin.GeometryError):
            burin.Scene().bounds()


class WithoutNumpy(unittest.TestCase):
    def test_arrays_say_what_to_install(self):
        scene = burin.Scene()
        with mock.patch.dict(sys.modules, {"numpy": None}):
            with self.assertRaisesRegex(ModuleNotFoundError, "pip install numpy"):
                scene.add_mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            with self.assertRaisesRegex(ModuleNotFoundError, "pip install numpy"):
                burin.Scene.read(SAMPLES / "spindle.stl").bounds()


class Functions(unittest.TestCase):
    BOX = (-6, -6, -6, 6, 6, 6)

    @staticmethod
    def ball(points):
        return np.linalg.norm(points, axis=1) - 5

    def test_sphere_is_where_it_is(self):
        scene = burin.Scene()
        scene.add_function(self.ball, self.BOX, "ball", samples=64)
        drawing = burin.draw(scene, style="outline", view="front")
        points = drawing.arrays()["points3"]
        self.assertGreater(len(points), 50)
        radius = np.linalg.norm(points, axis=1)
        # A cubic spline through samples 0.19 mm apart: h^4 of them, and the drawing's own rounding.
        self.assertLess(abs(radius - 5).max(), 2e-3)

    def test_few_calls(self):
        calls = []

        def counted(points):
            calls.append(points.shape)
            return self.ball(points)

        scene = burin.Scene()
        scene.add_function(counted, self.BOX, samples=32)
        self.assertEqual(calls, [(32 * 32, 3)] * 32)
        burin.draw(scene, style="outline")
        self.assertEqual(len(calls), 32)

    def test_exact_calls_agree_with_derivatives_given_and_not(self):
        def gradient(p):
            return p / np.linalg.norm(p, axis=1)[:, None]

        def hessian(p):
            r = np.linalg.norm(p, axis=1)[:, None, None]
            return (np.eye(3) - p[:, :, None] * p[:, None, :] / r**2) / r

        drawings = []
        for extra in ({}, {"gradients": gradient}, {"gradients": gradient, "hessians": hessian}):
            scene = burin.Scene()
            scene.add_function(self.ball, self.BOX, samples=0, **extra)
            drawings.append(burin.draw(scene, style="outline", tolerance=0.1).arrays()["points3"])
        for points in drawings:
            self.assertLess(abs(np.linalg.norm(points, axis=1) - 5).max(), 1e-4)

    def test_errors_of_the_function_are_passed_on(self):
        def broken(points):
            raise KeyError("mine")

        with self.assertRaisesRegex(KeyError, "mine"):
            burin.Scene().add_function(broken, self.BOX)
        with self.assertRaisesRegex(ValueError, r"values must give an array of shape \(\d+\)"):
            burin.Scene().add_function(lambda p: p, self.BOX)
        with self.assertRaises(TypeError):
            burin.Scene().add_function(lambda p: "text", self.BOX)
        with self.assertRaises(TypeError):
            burin.Scene().add_function(3, self.BOX)

    def test_nothing_there(self):
        for nothing in (lambda p: p[:, 0] ** 2 + 1, lambda p: np.full(len(p), np.nan)):
            with self.assertRaises(burin.GeometryError):
                burin.Scene().add_function(nothing, self.BOX, samples=16)

    def test_text(self):
        scene = burin.Scene()
        part = scene.add_implicit("r = 4;\ntorus(10, r)", "ring")
        self.assertEqual(part.name, "ring")
        np.testing.assert_allclose(scene.bounds(), [[-14, -14, -4], [14, 14, 4]], atol=0.05)
        with self.assertRaises(burin.InputError) as caught:
            scene.add_implicit("r = 4;\ntorus(10, q)")
        self.assertEqual(caught.exception.line, 2)


class Parts(unittest.TestCase):
    def test_flags(self):
        scene = burin.Scene()
        scene.add_mesh(*cube(), "front")
        vertices, triangles = cube()
        back = scene.add_mesh(vertices + [2, 20, 2], triangles, "back")

        def parts_drawn(**options):
            return set(burin.draw(scene, view="front", paper="A6", **options).arrays()["part"].tolist())

        self.assertEqual((back.drawn, back.hatched, back.transparent, back.listed, back.style), (True, True, False, True, None))
        self.assertEqual(parts_drawn(), {0, 1})
        scene.parts[0].drawn = False
        self.assertEqual(parts_drawn(), {1})
        scene.parts[0].drawn = True
        for part in scene.parts:
            part.hatched = False
        drawing = burin.draw(scene, style="engraving")
        self.assertFalse([p for layer in drawing.layers for p in layer.paths if p.kind == "stroke"])
        back.style = {"base": "outline", "line.outer": 1.5}
        self.assertEqual(scene.parts[1].style["line.outer"], 1.5)
        with self.assertRaises(burin.UsageError):
            back.style = "no such style"

    def test_names_can_be_changed(self):
        scene = burin.Scene()
        part = scene.add_mesh(*cube())
        part.name, part.color, part.assembly = "lid", "#00ff00", ["pump", "head"]
        entry = burin.draw(scene, style="outline").parts[0]
        self.assertEqual((entry["name"], entry["color"], entry["assembly"]), ("lid", "#00ff00", ["pump", "head"]))


if __name__ == "__main__":
    unittest.main()
