// Format: Pixar, "UsdPreviewSurface Specification", 2.6.
#include "craze/io/usd/usd_surface.h"

#include <array>
#include <numbers>

#include "craze/base/elementary.h"
#include "craze/base/text/format.h"
#include "craze/io/usd/usd_text.h"

namespace craze {

namespace {

std::string line(const std::string& text) {
  return "                " + text + "\n";
}

std::string shader(const std::string& name, const char* id, const std::string& inputs) {
  return fmt::format(
      "            def Shader \"{}\"\n            {{\n                uniform token info:id = "
      "\"{}\"\n{}            }}\n",
      name, id, inputs);
}

template <class Number, std::size_t n>
std::string tuple(const std::array<Number, n>& numbers) {
  std::string text;
  append_usd_tuple(text, numbers.data(), static_cast<int>(n));
  return text;
}

const char* wrap_name(TextureWrap wrap) {
  return wrap == TextureWrap::clamp ? "clamp" : wrap == TextureWrap::mirror ? "mirror" : "repeat";
}

/// How a picture's numbers become the surface's: scale x + bias.
struct Use {
  const char* color_space;
  Color scale{1, 1, 1, 1}, bias{0, 0, 0, 0};
};

class SurfaceWriter {
 public:
  explicit SurfaceWriter(const std::string& path) : path_(path) {}

  void number(const char* input, float value) {
    std::string text = fmt::format("float inputs:{} = ", input);
    append_usd_number(text, value);
    inputs_ += line(text);
  }

  void color(const char* input, const Color& c) {
    inputs_ += line(fmt::format("color3f inputs:{} = ", input) +
                    tuple(std::array<float, 3>{c[0], c[1], c[2]}));
  }

  /// `output` of a shader, as in "BaseColor.outputs:rgb".
  void connect(const char* type, const char* input, const std::string& output) {
    inputs_ += line(fmt::format("{} inputs:{}.connect = <{}/{}>", type, input, path_, output));
  }

  /// The picture as a shader of that name, with outputs rgb, r, g, b and a.
  void add_picture(const std::string& name, const LookPicture& picture, const Use& use) {
    std::string inputs = line("asset inputs:file = " + usd_asset(picture.file)) +
                         line("float4 inputs:scale = " + tuple(use.scale));
    if (use.bias != Color{0, 0, 0, 0}) inputs += line("float4 inputs:bias = " + tuple(use.bias));
    inputs += line(fmt::format("token inputs:sourceColorSpace = \"{}\"", use.color_space)) +
              line(fmt::format("float2 inputs:st.connect = <{}/{}.outputs:result>", path_,
                               uvs_of(name, picture))) +
              line(fmt::format("token inputs:wrapS = \"{}\"", wrap_name(picture.wraps[0]))) +
              line(fmt::format("token inputs:wrapT = \"{}\"", wrap_name(picture.wraps[1]))) +
              line("float3 outputs:rgb") + line("float outputs:r") + line("float outputs:g") +
              line("float outputs:b") + line("float outputs:a");
    shaders_ += shader(name, "UsdUVTexture", inputs);
  }

  void add_colors() {
    shaders_ +=
        shader("Color", "UsdPrimvarReader_float3",
               line("string inputs:varname = \"displayColor\"") + line("float3 outputs:result"));
  }

  std::string text() const {
    std::string all = fmt::format(
        "            token outputs:surface.connect = <{}/Surface.outputs:surface>\n", path_);
    all += shader("Surface", "UsdPreviewSurface", inputs_ + line("token outputs:surface"));
    all += shaders_;
    if (reads_uvs_) {
      all += shader("Uv", "UsdPrimvarReader_float2",
                    line("string inputs:varname = \"st\"") + line("float2 outputs:result"));
    }
    return all;
  }

 private:
  /// The shader that says where the picture called `name` lies.
  std::string uvs_of(const std::string& name, const LookPicture& picture) {
    reads_uvs_ = true;
    const auto& m = picture.place;
    if (m == LookPicture{}.place) return "Uv";
    // Scaled first, then turned, then moved.
    const double turn = elementary::atan2(m(1, 0), m(0, 0));
    const double c = elementary::cos(turn), s = elementary::sin(turn);
    const std::array<double, 2> scale{elementary::hypot(m(0, 0), m(1, 0)),
                                      c * m(1, 1) - s * m(0, 1)};
    std::string degrees;
    append_usd_number(degrees, turn * 180 / std::numbers::pi);
    shaders_ += shader(
        name + "Place", "UsdTransform2d",
        line(fmt::format("float2 inputs:in.connect = <{}/Uv.outputs:result>", path_)) +
            line("float inputs:rotation = " + degrees) +
            line("float2 inputs:scale = " + tuple(scale)) +
            line("float2 inputs:translation = " + tuple(std::array<double, 2>{m(0, 2), m(1, 2)})) +
            line("float2 outputs:result"));
    return name + "Place";
  }

  const std::string& path_;
  std::string inputs_, shaders_;
  bool reads_uvs_ = false;
};

bool has_file(const LookPicture& picture) {
  return !picture.file.empty();
}

void write_color(SurfaceWriter& surface, const MaterialLook& look) {
  if (!has_file(look.base_picture)) return surface.color("diffuseColor", look.base_color);
  surface.connect("color3f", "diffuseColor", "BaseColor.outputs:rgb");
  Use use{"sRGB", look.base_color};
  use.scale[3] *= 1 - look.transmission;
  surface.add_picture("BaseColor", look.base_picture, use);
}

void write_opacity(SurfaceWriter& surface, const MaterialLook& look) {
  using Alpha = MaterialLook::Alpha;
  if (look.alpha == Alpha::cut) surface.number("opacityThreshold", look.alpha_cutoff);
  if (look.alpha != Alpha::ignored && has_file(look.base_picture)) {
    return surface.connect("float", "opacity", "BaseColor.outputs:a");
  }
  const float cover = look.alpha == Alpha::ignored ? 1 : look.base_color[3];
  if (look.transmission > 0 && has_file(look.transmission_picture)) {
    surface.connect("float", "opacity", "Transmission.outputs:r");
    const float t = -cover * look.transmission;
    return surface.add_picture("Transmission", look.transmission_picture,
                               {"raw", {t, t, t, 1}, {cover, cover, cover, 0}});
  }
  const float opacity = cover * (1 - look.transmission);
  if (opacity != 1) surface.number("opacity", opacity);
}

void write_gloss(SurfaceWriter& surface, const MaterialLook& look) {
  if (!has_file(look.metallic_roughness_picture)) {
    surface.number("metallic", look.metallic);
    return surface.number("roughness", look.roughness);
  }
  surface.connect("float", "metallic", "MetallicRoughness.outputs:b");
  surface.connect("float", "roughness", "MetallicRoughness.outputs:g");
  surface.add_picture("MetallicRoughness", look.metallic_roughness_picture,
                      {"raw", {1, look.roughness, look.metallic, 1}});
}

void write_relief(SurfaceWriter& surface, const MaterialLook& look) {
  if (has_file(look.normal_picture)) {
    const float k = look.normal_strength;
    surface.connect("normal3f", "normal", "Normal.outputs:rgb");
    surface.add_picture("Normal", look.normal_picture,
                        {"raw", {2 * k, 2 * k, 2, 1}, {-k, -k, -1, 0}});
  }
  if (has_file(look.occlusion_picture)) {
    const float k = look.occlusion_strength;
    surface.connect("float", "occlusion", "Occlusion.outputs:r");
    surface.add_picture("Occlusion", look.occlusion_picture,
                        {"raw", {k, k, k, 1}, {1 - k, 1 - k, 1 - k, 0}});
  }
}

void write_emission(SurfaceWriter& surface, const MaterialLook& look) {
  const Color& c = look.emission;
  if (c[0] == 0 && c[1] == 0 && c[2] == 0) return;
  if (!has_file(look.emission_picture)) return surface.color("emissiveColor", c);
  surface.connect("color3f", "emissiveColor", "Emission.outputs:rgb");
  surface.add_picture("Emission", look.emission_picture, {"sRGB", c});
}

}  // namespace

std::string usd_surface(const MaterialLook& look, const std::string& path) {
  SurfaceWriter surface(path);
  write_color(surface, look);
  write_gloss(surface, look);
  write_opacity(surface, look);
  write_relief(surface, look);
  write_emission(surface, look);
  return surface.text();
}

std::string usd_surface_of_colors(const std::string& path) {
  SurfaceWriter surface(path);
  surface.connect("color3f", "diffuseColor", "Color.outputs:result");
  surface.add_colors();
  write_gloss(surface, {});
  return surface.text();
}

}  // namespace craze
