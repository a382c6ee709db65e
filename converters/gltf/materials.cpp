#include "materials.h"

#include <algorithm>
#include <string>

namespace burin::gltf {
namespace {

const tinygltf::Value* extension(const tinygltf::Material& material, const char* name) {
  const auto found = material.extensions.find(name);
  return found != material.extensions.end() && found->second.IsObject() ? &found->second : nullptr;
}

/// Whether what is behind is seen where the material says so: "MASK" cuts holes, which are not
/// known.
double opacity_of(const tinygltf::Material& material, double alpha) {
  double opacity = material.alphaMode == "BLEND" ? alpha : 1;
  if (const auto* glass = extension(material, "KHR_materials_transmission")) {
    const tinygltf::Value& factor = glass->Get("transmissionFactor");
    if (factor.IsNumber()) opacity = std::min(opacity, 1 - factor.GetNumberAsDouble());
  }
  return std::clamp(opacity, 0.0, 1.0);
}

/// The older way: diffuse colour instead of base colour. Whether a picture goes over it.
bool older_way(const tinygltf::Material& material, LinearColor& color) {
  const auto* older = extension(material, "KHR_materials_pbrSpecularGlossiness");
  if (older == nullptr) return false;
  const tinygltf::Value& factor = older->Get("diffuseFactor");
  for (std::size_t i = 0; i < color.size() && factor.IsArray() && i < factor.ArrayLen(); ++i) {
    const tinygltf::Value& one = factor.Get(i);
    if (one.IsNumber()) color[i] = one.GetNumberAsDouble();
  }
  return older->Has("diffuseTexture");
}

}  // namespace

std::optional<LinearColor> color_of(const tinygltf::Model& model, int material) {
  if (material < 0 || static_cast<std::size_t>(material) >= model.materials.size()) return {};
  const tinygltf::Material& m = model.materials[static_cast<std::size_t>(material)];
  const auto& base = m.pbrMetallicRoughness;
  LinearColor color{1, 1, 1, 1};
  for (std::size_t i = 0; i < color.size() && i < base.baseColorFactor.size(); ++i) {
    color[i] = base.baseColorFactor[i];
  }
  const bool pictured = older_way(m, color) || base.baseColorTexture.index >= 0;
  color[3] = opacity_of(m, color[3]);
  if (pictured && color[3] == 1) return {};
  return color;
}

}  // namespace burin::gltf
