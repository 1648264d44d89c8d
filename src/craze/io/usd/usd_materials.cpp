// Format: Pixar, "UsdPreviewSurface Specification", 2.6.
#include "craze/io/usd/usd_materials.h"

#include <fmt/format.h>

#include <array>

namespace craze {

namespace {

constexpr const char* scope = "/craze/Materials";

std::string tuple(const Color& c, int n) {
  std::string text;
  append_usd_tuple(text, c.data(), n);
  return text;
}

std::string shader(const char* name, const char* id, const std::string& inputs) {
  return fmt::format(
      "            def Shader \"{}\"\n            {{\n                uniform token info:id = "
      "\"{}\"\n{}            }}\n",
      name, id, inputs);
}

std::string line(const std::string& text) {
  return "                " + text + "\n";
}

}  // namespace

const std::string& UsdMaterials::path(std::int32_t face_material) {
  const auto [found, is_new] = paths_.try_emplace(face_material);
  if (!is_new) return found->second;
  const std::string name = face_material < 0 ? "surface" : mesh_.material_names[face_material];
  const std::string identifier = names_.take(name);
  found->second = fmt::format("{}/{}", scope, identifier);
  text_ += fmt::format("        def Material \"{}\"", identifier);
  if (identifier != name) text_ += fmt::format(" (displayName = {})", usd_string(name));
  text_ += "\n        {\n" + material(name, found->second, face_material) + "        }\n";
  return found->second;
}

std::string UsdMaterials::material(const std::string& name, const std::string& path,
                                   std::int32_t face_material) {
  std::string text = fmt::format(
      "            token outputs:surface.connect = <{}/Surface.outputs:surface>\n", path);
  // The base colour brings its own shaders after the surface.
  const std::string color = base_color(name, path, face_material);
  const std::size_t end = color.find('\n') + 1;
  text += shader("Surface", "UsdPreviewSurface",
                 color.substr(0, end) + line("float inputs:metallic = 0") +
                     line("float inputs:roughness = 0.8") + line("token outputs:surface"));
  return text + color.substr(end);
}

/// The input of the surface, one line, and the shaders that it is connected to.
std::string UsdMaterials::base_color(const std::string& name, const std::string& path,
                                     std::int32_t face_material) {
  const bool has_look = options_.looks && face_material >= 0 &&
                        static_cast<std::size_t>(face_material) < options_.looks->size();
  if (has_look && !(*options_.looks)[face_material].texture_file.empty()) {
    const MaterialLook& look = (*options_.looks)[face_material];
    return line(fmt::format("color3f inputs:diffuseColor.connect = <{}/Texture.outputs:rgb>",
                            path)) +
           shader("Texture", "UsdUVTexture",
                  line("asset inputs:file = " + usd_asset(look.texture_file)) +
                      line("float4 inputs:scale = " + tuple(look.base_color, 4)) +
                      line("token inputs:sourceColorSpace = \"sRGB\"") +
                      line(fmt::format("float2 inputs:st.connect = <{}/Uv.outputs:result>", path)) +
                      line("token inputs:wrapS = \"repeat\"") +
                      line("token inputs:wrapT = \"repeat\"") + line("float3 outputs:rgb")) +
           shader("Uv", "UsdPrimvarReader_float2",
                  line("string inputs:varname = \"st\"") + line("float2 outputs:result"));
  }
  const bool is_wall = name == "crack_wall";
  if (!is_wall && !has_look && !mesh_.vertex_colors.empty()) {
    return line(fmt::format("color3f inputs:diffuseColor.connect = <{}/Color.outputs:result>",
                            path)) +
           shader("Color", "UsdPrimvarReader_float3",
                  line("string inputs:varname = \"displayColor\"") + line("float3 outputs:result"));
  }
  const float grey = is_wall ? 0.25f : 0.8f;  // as in GLB
  const Color color =
      has_look ? (*options_.looks)[face_material].base_color : Color{grey, grey, grey, 1};
  return line("color3f inputs:diffuseColor = " + tuple(color, 3));
}

std::string UsdMaterials::text() const {
  if (text_.empty()) return "";
  return "    def Scope \"Materials\"\n    {\n" + text_ + "    }\n";
}

}  // namespace craze
