#include "craze/job/material_looks.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>

#include "craze/error.h"
#include "craze/io/files/sibling_files.h"
#include "craze/io/image/read_image.h"

namespace craze {

namespace {

bool says_something(const MaterialLook& look) {
  const Color& c = look.base_color;
  return look.base_picture || look.normal_picture || c[0] != c[1] || c[1] != c[2] ||
         look.transmission > 0 || look.alpha != MaterialLook::Alpha::ignored;
}

class TextureReader {
 public:
  TextureReader(const std::string& input, std::vector<std::string>& warnings,
                const Context& context)
      : input_(input), warnings_(warnings), context_(context) {}

  render::PlacedTexture of(const LookPicture& picture, render::Encoding encoding) {
    return {texture(picture, encoding), picture.place.cast<float>(), picture.wraps};
  }

 private:
  using Texture = std::shared_ptr<const render::ColorTexture>;

  Texture texture(const LookPicture& picture, render::Encoding encoding) {
    if (!picture) return nullptr;
    const auto [found, is_new] = known_.try_emplace({picture.bytes.get(), picture.file, encoding});
    if (is_new) {
      context_.check();
      try {
        found->second = std::make_shared<const render::ColorTexture>(read(picture), encoding);
      } catch (const Error& e) {
        warnings_.push_back(fmt::format("a texture is not shown in pictures: {}", e.what()));
      }
    }
    return found->second;
  }

  Image read(const LookPicture& picture) const {
    if (picture.bytes) return read_image(*picture.bytes, "a texture in " + input_);
    const auto folder = std::filesystem::path(input_).parent_path();
    const std::string bytes = load_from_folder(folder, context_)(picture.file);
    return read_image(bytes, picture.file);
  }

  const std::string& input_;
  std::vector<std::string>& warnings_;
  const Context& context_;
  std::map<std::tuple<const std::string*, std::string, render::Encoding>, Texture> known_;
};

}  // namespace

std::vector<render::Look> material_looks(const std::vector<MaterialLook>& looks,
                                         const std::string& input,
                                         std::vector<std::string>& warnings,
                                         const Context& context) {
  if (std::any_of(looks.begin(), looks.end(),
                  [](const MaterialLook& look) { return look.has_further_uvs; })) {
    warnings.emplace_back("textures that lie in a further UV set are not shown in pictures");
  }
  if (std::none_of(looks.begin(), looks.end(), says_something)) return {};
  TextureReader textures(input, warnings, context);
  std::vector<render::Look> shown;
  using render::Encoding;
  for (const MaterialLook& look : looks) {
    const Color& c = look.base_color;
    render::Look& one = shown.emplace_back();
    one.color = {c[0], c[1], c[2]};
    one.picture = textures.of(look.base_picture, Encoding::srgb);
    one.alpha = look.alpha;
    one.opacity = c[3];
    one.cutoff = look.alpha_cutoff;
    one.transmission = look.transmission;
    if (one.transmission > 0) {
      one.transmission_picture = textures.of(look.transmission_picture, Encoding::linear);
      // One that cannot be read could have said that nothing is transmitted.
      if (look.transmission_picture && !one.transmission_picture) one.transmission = 0;
    }
    one.normals = textures.of(look.normal_picture, Encoding::linear);
    one.normal_strength = look.normal_strength;
  }
  return shown;
}

}  // namespace craze
