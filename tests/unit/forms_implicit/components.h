#pragma once
/// What is found of the components of an implicit surface.

#include <burin/forms/implicit/expression.h>
#include <burin/forms/implicit/implicit_form.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

namespace burin::test {

inline bool says(const Diagnostics& diagnostics, const std::string& code) {
  return std::ranges::find(diagnostics.entries(), code, &Diagnostic::code) !=
         diagnostics.entries().end();
}

struct Found {
  std::size_t components = 0;
  TriMesh mesh;
  Diagnostics diagnostics;

  bool says(const std::string& code) const { return test::says(diagnostics, code); }
};

/// All components closed, and what may be missing told once at most.
inline Found found_of(const Form& form) {
  RunContext context;
  Found found;
  RealiseOptions options;
  options.tolerance = 0.01;
  options.diagnostics = &found.diagnostics;
  const auto surface = form.realise(options, context);
  found.components = surface->proxy().topology.component_closed.size();
  for (const auto closed : surface->proxy().topology.component_closed) EXPECT_TRUE(closed);
  found.mesh = surface->proxy().mesh;
  EXPECT_LE(std::ranges::count(found.diagnostics.entries(), "implicit.may_miss", &Diagnostic::code),
            1);
  return found;
}

inline Found find(const std::shared_ptr<const ImplicitFunction>& f,
                  std::optional<Box3> domain = {}) {
  return found_of(ImplicitForm(f, domain, RunContext()));
}

inline Found find(const Expression& e, std::optional<Box3> domain = {}) {
  return find(make_function(e), domain);
}

/// The part of a mesh nearer to a place than `reach`.
inline TriMesh around(const TriMesh& mesh, Vec3 p, double reach) {
  TriMesh out = mesh;
  std::erase_if(out.triangles, [&](const Triangle& t) {
    return std::ranges::any_of(
        t, [&](std::uint32_t v) { return glm::distance(mesh.positions[v], p) >= reach; });
  });
  return out;
}

/// Of what triangles use.
inline Box3 box_of(const TriMesh& mesh) {
  Box3 box;
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) box.add(mesh.positions[v]);
  }
  return box;
}

}  // namespace burin::test
