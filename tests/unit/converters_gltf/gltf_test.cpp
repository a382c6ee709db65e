#include "gltf_files.h"

namespace burin {
namespace {

using test::bounds_of;
using test::expect_box;
using test::Gltf;
using test::Json;
using test::read_gltf_bytes;
using test::small_box;

Gltf one_box() {
  Gltf g;
  g.node({{"mesh", g.mesh(small_box())}, {"name", "lid"}});
  return g;
}

TEST(Gltf, MetresWithYUpBecomeMmWithZUp) {
  Gltf g = one_box();
  const Scene scene = read_gltf_bytes(g.glb());
  ASSERT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(scene.parts[0].name, "lid");
  EXPECT_EQ(scene.parts[0].color, "");
  expect_box(bounds_of(scene, 0), {0, -30, 0}, {10, 0, 20});
  RunContext context;
  EXPECT_NEAR(scene.parts[0].form->measure(context).volume, 6000, 0.01);  // right side out
  EXPECT_TRUE(scene.diagnostics.empty());
}

TEST(Gltf, TextWithItsBytesInsideOrBesideIt) {
  Gltf g = one_box();
  expect_box(bounds_of(read_gltf_bytes(g.gltf(g.data_uri()), "a.gltf"), 0), {0, -30, 0},
             {10, 0, 20});
  const test::Folder folder;
  const RunContext context;
  folder.write("my data.bin", g.bytes + "more than is needed");
  const std::string path = folder.write("a.gltf", g.gltf("my%20data.bin"));
  expect_box(bounds_of(read_gltf(path, context), 0), {0, -30, 0}, {10, 0, 20});
}

TEST(Gltf, IsKnownByContent) {
  Gltf g = one_box();
  EXPECT_TRUE(is_gltf_content(g.glb()));
  EXPECT_TRUE(is_gltf_content(g.gltf("x.bin").substr(0, 4096)));
  EXPECT_FALSE(is_gltf_content("{\"format\": \"burin-drawing\", \"version\": 1}"));
  EXPECT_TRUE(is_gltf_suffix("a.GLB"));
  EXPECT_FALSE(is_gltf_suffix("a.obj"));
}

TEST(Gltf, NodesTurnMoveAndScale) {
  Gltf g;
  const int mesh = g.mesh(small_box(), "block");
  const double half = std::sqrt(0.5);
  // A quarter turn about y (up) takes x to -z: our -x to ... y.
  const int inner = g.node(
      {{"mesh", mesh}, {"name", "turned"}, {"rotation", {0, half, 0, half}}, {"scale", {2, 2, 2}}},
      false);
  g.node({{"name", "arm"}, {"translation", {1, 0, 0}}, {"children", {inner}}});
  g.node({{"mesh", mesh},
          {"name", "by matrix"},
          {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0.5, 0, 1}}});
  const Scene scene = read_gltf_bytes(g.glb());
  ASSERT_EQ(scene.parts.size(), 2u);
  expect_box(bounds_of(scene, 0), {1000, 0, 0}, {1060, 20, 40});
  EXPECT_EQ(scene.parts[0].assembly, std::vector<std::string>{"arm"});
  expect_box(bounds_of(scene, 1), {0, -30, 500}, {10, 0, 520});
  EXPECT_EQ(scene.parts[0].form->definition().shape, scene.parts[1].form->definition().shape);
  EXPECT_NEAR(glm::determinant(scene.parts[0].form->definition().linear), 8, 1e-5);
}

TEST(Gltf, InstancesAreCalledAsTheirMeshWhereTheirNamesDiffer) {
  const auto read = [](const std::vector<std::string>& names) {
    Gltf g;
    const int mesh = g.mesh(small_box(), "M6 bolt");
    for (std::size_t i = 0; i < names.size(); ++i) {
      g.node({{"mesh", mesh}, {"name", names[i]}, {"translation", {i, 0, 0}}});
    }
    return read_gltf_bytes(g.glb());
  };
  const Scene differ = read({"left", "right"});
  EXPECT_EQ(differ.parts.at(0).definition, "M6 bolt");
  EXPECT_EQ(differ.parts.at(1).name, "right");
  EXPECT_EQ(read({"Bolt.001", "Bolt.002"}).parts.at(1).definition, "");
  EXPECT_EQ(read({"lone"}).parts.at(0).definition, "");
  EXPECT_EQ(read({""}).parts.at(0).name, "M6 bolt");
}

TEST(Gltf, MirroredAndStretchedNodesAreDrawn) {
  Gltf g;
  const int mesh = g.mesh(small_box(), "block");
  g.node({{"mesh", mesh}});
  g.node({{"mesh", mesh}, {"scale", {-1, 1, 1}}});
  g.node({{"mesh", mesh}, {"scale", {1, 3, 1}}});
  const Scene scene = read_gltf_bytes(g.glb());
  ASSERT_EQ(scene.parts.size(), 3u);
  expect_box(bounds_of(scene, 1), {-10, -30, 0}, {0, 0, 20});
  expect_box(bounds_of(scene, 2), {0, -30, 0}, {10, 0, 60});
  RunContext context;
  EXPECT_NEAR(scene.parts[1].form->measure(context).volume, 6000, 0.01);
  EXPECT_NEAR(scene.parts[2].form->measure(context).volume, 18000, 0.01);
  EXPECT_TRUE(scene.diagnostics.empty());
}

TEST(Gltf, ColoursAndOpacityOfMaterials) {
  Gltf g;
  g.json["materials"] = {
      {{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 0.3}}}}},
      {{"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0.21586050, 0.25}}}},
       {"alphaMode", "BLEND"}},
      {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}},
      {{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 0.8}}}}}},
      {{"extensions",
        {{"KHR_materials_pbrSpecularGlossiness", {{"diffuseFactor", {0, 1, 0, 1}}}}}}}};
  for (int m = 0; m < 5; ++m) {
    g.node({{"mesh", g.mesh(small_box(), "", m)}, {"translation", {m, 0, 0}}});
  }
  const Scene scene = read_gltf_bytes(g.glb());
  ASSERT_EQ(scene.parts.size(), 5u);
  const std::vector<std::string> colors = {"#ff0000", "#000080", "", "#ffffff", "#00ff00"};
  const std::vector<double> opacity = {1, 0.25, 1, 0.2, 1};
  for (std::size_t i = 0; i < colors.size(); ++i) {
    EXPECT_EQ(scene.parts[i].color, colors[i]) << i;
    EXPECT_NEAR(scene.parts[i].opacity, opacity[i], 1 / 255.0) << i;
  }
}

TEST(Gltf, PrimitivesAreOnePartButForGlass) {
  Gltf g;
  g.json["materials"] = {
      {{"name", "steel"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}}}},
      {{"name", "paint"}, {"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 1, 1}}}}},
      {{"name", "window"},
       {"alphaMode", "BLEND"},
       {"pbrMetallicRoughness", {{"baseColorFactor", {0, 1, 0, 0.5}}}}}};
  const auto primitive = [&](int material, double x) {
    const int points = g.points({{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
    return Json{{"attributes", {{"POSITION", points}}}, {"material", material}};
  };
  g.json["meshes"] = {{{"primitives", {primitive(0, 0), primitive(1, 1)}}},
                      {{"primitives", {primitive(0, 0), primitive(2, 1)}}}};
  g.node({{"mesh", 0}, {"name", "door"}});
  g.node({{"mesh", 1}, {"name", "hatch"}});
  const Scene scene = read_gltf_bytes(g.glb());
  ASSERT_EQ(scene.parts.size(), 3u);
  EXPECT_EQ(scene.parts[0].name, "door");
  EXPECT_EQ(scene.parts[0].color, "#ff0000") << "of two of one size the first";
  ASSERT_TRUE(scene.parts[0].face_colors);
  EXPECT_EQ(scene.parts[0].face_colors->colors, std::vector<std::string>{"#0000ff"});
  EXPECT_EQ(scene.parts[1].name, "hatch");
  EXPECT_EQ(scene.parts[1].color, "#ff0000");
  EXPECT_EQ(scene.parts[2].name, "hatch window");
  EXPECT_EQ(scene.parts[2].color, "#00ff00");
  EXPECT_LT(scene.parts[2].opacity, 1);
}

TEST(Gltf, StripsFansAndPrimitivesWithoutIndices) {
  const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const std::vector<Vec3> around = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  for (const int mode : {5, 6}) {
    Gltf g;
    g.json["meshes"] = {{{"primitives",
                          {{{"attributes", {{"POSITION", g.points(mode == 5 ? square : around)}}},
                            {"mode", mode}}}}}};
    g.node({{"mesh", 0}});
    const Scene scene = read_gltf_bytes(g.glb());
    RunContext context;
    EXPECT_NEAR(scene.parts.at(0).form->measure(context).area, 1e6, 1);
    EXPECT_EQ(test::count_of(scene.diagnostics, "mesh.flipped_faces"), 0) << mode;
    expect_box(bounds_of(scene, 0), {0, 0, 0}, {1000, 0, 1000});
  }
}

TEST(Gltf, SparseAndQuantisedAndStridedAccessors) {
  Gltf sparse;
  const int points = sparse.points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const int where = sparse.view(Gltf::packed<std::uint8_t>({1}));
  const int what = sparse.view(Gltf::packed<float>({3, 0, 0}));
  sparse.json["accessors"][static_cast<std::size_t>(points)]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", where}, {"componentType", test::kUByte}}},
      {"values", {{"bufferView", what}}}};
  sparse.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", points}}}}}}}};
  sparse.node({{"mesh", 0}});
  expect_box(bounds_of(read_gltf_bytes(sparse.glb()), 0), {0, 0, 0}, {3000, 0, 1000});

  Gltf small;
  const int shorts = small.accessor(
      small.view(Gltf::packed<std::int16_t>({0, 0, 0, 9, 32767, 0, 0, 9, 0, 32767, 0, 9}), 8),
      test::kShort, 3, "VEC3");
  small.json["accessors"][static_cast<std::size_t>(shorts)]["normalized"] = true;
  small.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  small.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", shorts}}}}}}}};
  small.node({{"mesh", 0}, {"scale", {0.5, 0.5, 0.5}}});
  expect_box(bounds_of(read_gltf_bytes(small.glb()), 0), {0, 0, 0}, {500, 0, 500});
}

TEST(Gltf, MorphsAndSkinsStandAsTheNodesHaveThem) {
  Gltf g;
  const int points = g.points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const int moves = g.points({{0, 0, 0}, {2, 0, 0}, {0, 0, 0}});
  g.json["meshes"] = {
      {{"primitives",
        {{{"attributes", {{"POSITION", points}}}, {"targets", {{{"POSITION", moves}}}}}}},
       {"weights", {0.5}}}};
  g.node({{"mesh", 0}});
  g.node({{"mesh", 0}, {"weights", {0.0}}, {"translation", {0, 0, 5}}});
  const Scene morphs = read_gltf_bytes(g.glb());
  expect_box(bounds_of(morphs, 0), {0, 0, 0}, {2000, 0, 1000});
  expect_box(bounds_of(morphs, 1), {0, -5000, 0}, {1000, -5000, 1000});

  Gltf s;
  const int corners = s.points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const int joints =
      s.accessor(s.view(Gltf::packed<std::uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0})),
                 test::kUByte, 3, "VEC4");
  const int weights =
      s.accessor(s.view(Gltf::packed<float>({1, 0, 0, 0, 0, 1, 0, 0, 0.5, 0.5, 0, 0})),
                 test::kFloat, 3, "VEC4");
  s.json["meshes"] = {
      {{"primitives",
        {{{"attributes",
           {{"POSITION", corners}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}}}}}}};
  s.json["skins"] = {{{"joints", {0, 1}}}};
  s.node({{"name", "root"}});
  s.node({{"name", "hand"}, {"translation", {2, 0, 0}}});
  s.node({{"mesh", 0}, {"skin", 0}, {"translation", {77, 0, 0}}});  // which skins do not follow
  expect_box(bounds_of(read_gltf_bytes(s.glb()), 0), {0, 0, 0}, {3000, 0, 1000});
}

TEST(Gltf, InstancesOfTheGpu) {
  Gltf g;
  const int mesh = g.mesh(small_box(), "block");
  const int moves = g.points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  g.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  g.node(
      {{"mesh", mesh},
       {"name", "row"},
       {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", moves}}}}}}}});
  const Scene scene = read_gltf_bytes(g.glb());
  ASSERT_EQ(scene.parts.size(), 3u);
  expect_box(bounds_of(scene, 2), {2000, -30, 0}, {2010, 0, 20});
}

TEST(Gltf, WhatIsNotDrawnIsTold) {
  Gltf g = one_box();
  const int line = g.points({{0, 0, 0}, {1, 0, 0}});
  g.json["meshes"].push_back(
      {{"primitives", {{{"attributes", {{"POSITION", line}}}, {"mode", 1}}}}});
  g.node({{"mesh", 1}});
  g.node({{"mesh", 0}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}});
  g.json["scenes"].push_back({{"nodes", Json::array()}});
  const Scene scene = read_gltf_bytes(g.glb());
  EXPECT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(test::count_of(scene.diagnostics, "gltf.no_faces"), 1);
  EXPECT_EQ(test::count_of(scene.diagnostics, "gltf.hidden"), 1);
  EXPECT_EQ(test::count_of(scene.diagnostics, "gltf.other_scenes"), 1);
}

void expect_refused(const std::string& bytes, const std::string& part,
                    const std::string& name = "a.glb") {
  try {
    read_gltf_bytes(bytes, name);
    ADD_FAILURE() << "was read; expected: " << part;
  } catch (const InputError& e) {
    const std::string what = e.what();
    EXPECT_NE(what.find(part), std::string::npos) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  }
}

TEST(Gltf, ExtensionsThatAreNeededAndNotReadAreNamed) {
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
    Gltf g = one_box();
    g.json["extensionsRequired"] = {"KHR_materials_unlit", name};
    expect_refused(g.glb(), name);
    expect_refused(g.glb(), "without compression of meshes");
  }
  Gltf other = one_box();
  other.json["extensionsRequired"] = {"ACME_shape"};
  expect_refused(other.glb(), "needs the extension 'ACME_shape' of glTF, which is not read");
}

TEST(Gltf, DamagedFilesAreRefused) {
  Gltf g = one_box();
  const std::string good = g.glb();
  for (std::size_t n = 0; n < good.size(); n += 7) expect_refused(good.substr(0, n), "");
  const auto changed = [](const auto& change) {
    Gltf other = one_box();
    change(other.json);
    return other.glb();
  };
  expect_refused(changed([](Json& j) { j["asset"]["version"] = "1.0"; }), "version '1.0'");
  expect_refused(changed([](Json& j) { j["accessors"][0]["count"] = 1'000'000'000; }),
                 "accessor 0 of the glTF claims more");
  expect_refused(changed([](Json& j) { j["accessors"][0]["count"] = 9; }), "claims more");
  expect_refused(changed([](Json& j) { j["accessors"][0]["bufferView"] = 7; }), "not there");
  expect_refused(changed([](Json& j) { j["bufferViews"][0]["byteLength"] = 1 << 30; }),
                 "claims more");
  expect_refused(changed([](Json& j) { j["accessors"][0]["count"] = 2; }), "refers to vertex");
  expect_refused(changed([](Json& j) { j["nodes"][0]["mesh"] = 3; }), "is not there");
  expect_refused(changed([](Json& j) { j["nodes"][0]["children"] = {0}; }), "in two places");
  expect_refused(changed([](Json& j) { j["scenes"][0]["nodes"] = {5}; }), "is not there");
  expect_refused(changed([](Json& j) { j["scenes"][0]["nodes"] = Json::array(); }),
                 "has no triangles");
  expect_refused("{\"asset\": {\"version\": \"2.0\"}, \"a\": " + std::string(100'000, '[') +
                     std::string(100'000, ']') + "}",
                 "100 deep", "a.gltf");
  expect_refused("{\"asset\": {\"version\": \"2.0\"", "truncated", "a.gltf");
  Gltf beside = one_box();
  expect_refused(beside.gltf("gone.bin"), "needs the file gone.bin, which is not there", "a.gltf");
  expect_refused(beside.gltf("data:application/octet-stream;base64,AAAA"), "", "a.gltf");
}

TEST(Gltf, WhatTheFileDoesNotHoldIsLeftOutAndTold) {
  Gltf g = one_box();
  g.json["nodes"].push_back({{"mesh", 7}});
  g.json["scenes"][0]["nodes"] = {0, 1, 9};
  const Scene scene = read_gltf_bytes(g.glb());
  EXPECT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(test::count_of(scene.diagnostics, "gltf.missing"), 2);
}

TEST(Gltf, CancelledReadingStops) {
  Gltf g = one_box();
  const test::TempFile file("a.glb", g.glb());
  RunContext context;
  context.cancel();
  EXPECT_THROW(read_gltf(file.path(), context), Cancelled);
}

}  // namespace
}  // namespace burin
