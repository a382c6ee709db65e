"""Where the fuzzing of a target begins: samples, real files beside the project, a cylinder as FreeCAD writes it and the
files below; the small ones of each."""
import base64
import io
import json
import pathlib
import struct
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Bytes of one seed, and of all of a target: what is read a thousand times has to be small.
LARGEST, ALL = 150_000, 400_000

SUFFIXES = {"step": ("step", "stp"), "iges": ("iges", "igs"), "brep": ("brep", "brp")}
MEMBERS = {"3mf-model": ("3mf", "3D/3dmodel.model"), "fcstd-document": ("fcstd", "Document.xml")}
SPHERE = bytes(min(255, 60 * ((x - 2) ** 2 + (y - 2) ** 2 + (z - 2) ** 2)) for z in range(5) for y in range(5)
               for x in range(5))
TETRAHEDRON = ("0 0 0", "1 0 0", "0 1 0", "0 0 1"), ("0 2 1", "0 1 3", "1 2 3", "0 3 2")


def tetrahedron(point, triangle):
    points, triangles = TETRAHEDRON
    return ("".join(point.format(*p.split()) for p in points),
            "".join(triangle.format(*t.split()) for t in triangles))


def binary_stl():
    points, triangles = TETRAHEDRON
    body = b""
    for triangle in triangles:
        corners = [float(x) for i in triangle.split() for x in points[int(i)].split()]
        body += struct.pack("<12fH", 0, 0, 0, *corners, 0)
    return bytes(80) + struct.pack("<I", len(triangles)) + body


def nifti():
    head = bytearray(352)
    struct.pack_into("<i", head, 0, 348)
    struct.pack_into("<8h", head, 40, 3, 5, 5, 5, 1, 1, 1, 1)
    struct.pack_into("<2h", head, 70, 2, 8)
    struct.pack_into("<8f", head, 76, 1, 1, 1, 1, 1, 1, 1, 1)
    struct.pack_into("<f", head, 108, 352)
    head[344:348] = b"n+1\0"
    return bytes(head) + SPHERE


def inrimage():
    head = "#INRIMAGE-4#{\nXDIM=5\nYDIM=5\nZDIM=5\nVDIM=1\nTYPE=unsigned fixed\nPIXSIZE=8 bits\nCPU=decm\nVX=1\n"
    return (head.ljust(252, "\n") + "##}\n").encode() + SPHERE


def vti():
    numbers = " ".join(map(str, SPHERE))
    return ('<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian"><ImageData WholeExtent="0 4 0 4 0 4" '
            'Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 4 0 4 0 4"><PointData Scalars="s"><DataArray type="UInt8" '
            f'Name="s" format="ascii">{numbers}</DataArray></PointData></Piece></ImageData></VTKFile>')


def model_3mf():
    points, triangles = tetrahedron('<vertex x="{}" y="{}" z="{}"/>', '<triangle v1="{}" v2="{}" v3="{}"/>')
    return ('<model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>'
            f'<object id="1" type="model"><mesh><vertices>{points}</vertices><triangles>{triangles}</triangles></mesh>'
            '</object><object id="2"><components><component objectid="1" transform="1 0 0 0 1 0 0 0 1 2 0 0"/>'
            '</components></object></resources><build><item objectid="2"/></build></model>')


def gltf(binary):
    """Two nodes of one mesh, a sparse accessor and a material."""
    points, triangles = TETRAHEDRON
    data = b"".join(struct.pack("<f", float(x)) for p in points for x in p.split())
    data += b"".join(struct.pack("<H", int(i)) for t in triangles for i in t.split())
    data += struct.pack("<H2x3f", 1, 2, 0, 0)
    views = [(0, 48), (48, 24), (72, 2), (76, 12)]
    scene = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 0, "name": "a", "children": [2]}, {"mesh": 0, "rotation": [0, 1, 0, 0], "scale": [2, 2, 2]},
                  {"mesh": 0, "skin": 0, "weights": [0.5]}],
        "skins": [{"joints": [1]}], "materials": [{"alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor":
                                                                                               [1, 0, 0, 0.5]}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0, "targets":
                                    [{"POSITION": 0}]}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "sparse": {
            "count": 1, "indices": {"bufferView": 2, "componentType": 5123}, "values": {"bufferView": 3}}},
                      {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": at, "byteLength": size} for at, size in views],
        "buffers": [{"byteLength": len(data)}]}
    if not binary:
        scene["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
        return json.dumps(scene)
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<4s2I", b"glTF", 2, 28 + len(text) + len(data)) + struct.pack("<I4s", len(text), b"JSON") + text +
            struct.pack("<I4s", len(data), b"BIN\0") + data)


def archive_3mf():
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(zipfile.ZipInfo("3D/3dmodel.model"), model_3mf())
    return stream.getvalue()


def own(target):
    """Files of this page: one of each kind that has no small sample."""
    off = tetrahedron("{} {} {}\n", "3 {} {} {}\n")
    ply = ("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
           "element face 4\nproperty list uchar int vertex_indices\nend_header\n")
    raw_head = "ObjectType = Image\nNDims = 3\nDimSize = 5 5 5\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n"
    nrrd = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 5 5 5\nencoding: raw\n\n"
    return {
        "stl": [binary_stl()],
        "obj": ["o part\n" + "".join(tetrahedron("v {} {} {}\n", "f {} {} {} -1\n")).replace("f 0", "f 4")],
        "off": ["OFF\n4 4 0\n" + "".join(off)],
        "ply": [ply + "".join(off)],
        "3mf": [archive_3mf()],
        "gltf": [gltf(binary=False)],
        "glb": [gltf(binary=True)],
        "3mf-model": [model_3mf()],
        "fcstd-document": [
            '<Document SchemaVersion="4"><Objects Count="1"><Object type="Part::Feature" name="Box" id="1"/></Objects>'
            '<ObjectData Count="1"><Object name="Box"><Properties Count="1"><Property name="Shape" '
            'type="Part::PropertyPartShape"><Part file="Box.brp"/></Property></Properties></Object></ObjectData>'
            '</Document>'],
        "nrrd": [nrrd.encode() + SPHERE],
        "mha": [raw_head.encode() + SPHERE],
        "inr": [inrimage()],
        "nii": [nifti()],
        "vti": [vti()],
        "csg": ['difference() {\n\tcube(size = [10, 10, 10], center = false);\n%\tgroup() { text(text = "a "b"", size = 1); }\n'
                'multmatrix([[1, 0, 0, -2], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { sphere($fn = 0, $fa = 12, $fs = 2, '
                'r = 1e-3); }\n}\npolygon(points = [[0, 0], [1, nan]], paths = undef, convexity = 1); // end\n'],
        "style": ['{"name": "a", "line": {"outer": 0.5}, "hatch": {"enabled": true, "field": "fixed", '
                  '"direction": [0, 1, 0]}}', '{"based_on": "engraving", "feature": {"crease_angle": 40}}'],
        "illustration": [
            '{"burin": "illustration", "version": 1, "title": "a", "parts": [{"file": "a.step", "name": "b", "place": '
            '{"translate": [0, 0, 1], "rotate": [0, 90, 0], "scale": 2}}, {"function": "torus(20, 8)", "bounds": '
            '[0, 0, 0, 1, 1, 1]}], "view": {"from": "iso", "up": [0, 0, 1], "perspective": 30, "scale": "1:2"}, "paper": '
            '{"size": "A4", "margin": [1, 2, 3, 4]}, "lights": [{"ambient": 0.2}, {"at": [1, 2, 3], "strength": 0.3}], '
            '"style": {"base": "engraving", "hatch": {"taper": 1}}, "looks": [{"select": ["a", "@color=#000000"], "drawn": '
            'false, "style": "outline"}]}'],
        "drawing": [
            '{"format": "burin-drawing", "version": 1, "paper": {"width": 20, "height": 10}, "layers": [{"name": '
            '"outline", "paths": [{"kind": "contour", "width": [0.2, 0.5], "points": [[1, 1], [9, 2.5]]}, '
            '{"points": [[1, 2], [3, 4], [5, 1]], "closed": true}]}]}'],
        "plugin": [
            "burin-probe 1\nok\n", "burin-probe 1\nfault it has no version\n",
            '{"format": "burin-plugins-tried-1", "files": {"/a/b.so": {"identity": "1-2-3-4.5-6.7", "probe": '
            '"1-2-3-4.5-6.7", "fault": "it crashes"}, "/c.so": {"identity": "1", "probe": "2", "fault": ""}}}'],
        "options": [
            "view=front\npaper=A4\nscale=1:2\nmargin=10,5,5,10\nset=line.outer=0.5\nbounds=-1,-1,-1,1,1,1\niso=50%",
            "view=0.3,-1,0.45\nup=0,0,1\nperspective=40\npaper=120x80\nscale=fit\ncenter=1,2,3\nlight=1,0,1\n"
            "hidden=dashed\ntolerance=0.01\nseed=7\nthreads=2\nset=hatch.field=planes\nset=hatch.direction=0,1,0\n"
            "volume_degree=2\nsmooth=1\nspecks=3\nraw=10x10x10:u8\nraw_skip=5\nheal=true\nmesher=nets\ndefine=a=3"],
    }.get(target, [])


def fill(target, folder, data):
    """Writes the seeds of a target into a folder, the smallest first; their number."""
    suffixes = SUFFIXES.get(target, (target.lower(),))
    member = None
    if target in MEMBERS:
        suffixes, member = (MEMBERS[target][0],), MEMBERS[target][1]
    tops = [ROOT / "samples", ROOT / "tests/fuzz/cylinder", data]
    found = [path for top in tops if top.is_dir() for path in top.rglob("*")
             if path.suffix.lower().lstrip(".") in suffixes and path.is_file()]
    if target == "drawing":
        found = list((ROOT / "tests/golden/drawings").glob("*.json"))
    seeds = [text.encode() if isinstance(text, str) else text for text in own(target)]
    for path in found:
        if not member:
            if path.stat().st_size <= LARGEST:
                seeds.append(path.read_bytes())
        elif zipfile.is_zipfile(path):
            with zipfile.ZipFile(path) as archive:
                if member in archive.namelist() and archive.getinfo(member).file_size <= LARGEST:
                    seeds.append(archive.read(member))
    count = total = 0
    for seed in sorted(set(seeds), key=lambda seed: (len(seed), seed)):
        total += len(seed)
        if count > 0 and total > ALL:
            break
        (folder / f"seed-{count:03}").write_bytes(seed)
        count += 1
    return count
