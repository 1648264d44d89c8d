#include "craze/job/material_looks.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "craze/error.h"
#include "craze/io/files/sibling_files.h"
#include "craze/io/image/read_image.h"

namespace craze {

namespace {

bool has_texture(const MaterialLook& look) {
  return look.texture || !look.texture_file.empty();
}

bool says_something(const MaterialLook& look) {
  const Color& c = look.base_color;
  return has_texture(look) || c[0] != c[1] || c[1] != c[2] || look.transmission > 0 ||
         look.alpha != MaterialLook::Alpha::ignored;
}

class TextureReader {
 public:
  TextureReader(const std::string& input, std::vector<std::string>& warnings,
                const Context& context)
      : input_(input), warnings_(warnings), context_(context) {}

  std::shared_ptr<const render::ColorTexture> of(const MaterialLook& look) {
    if (!has_texture(look)) return nullptr;
    const auto [found, is_new] = known_.try_emplace({look.texture.get(), look.texture_file});
    if (is_new) {
      context_.check();
      try {
        found->second = std::make_shared<const render::ColorTexture>(read(look));
      } catch (const Error& e) {
        warnings_.push_back(fmt::format("a texture is not shown in pictures: {}", e.what()));
      }
    }
    return found->second;
  }

 private:
  Image read(const MaterialLook& look) const {
    if (look.texture) return read_image(*look.texture, "a texture in " + input_);
    const auto folder = std::filesystem::path(input_).parent_path();
    const std::string bytes = load_from_folder(folder, context_)(look.texture_file);
    return read_image(bytes, look.texture_file);
  }

  const std::string& input_;
  std::vector<std::string>& warnings_;
  const Context& context_;
  std::map<std::pair<const std::string*, std::string>, std::shared_ptr<const render::ColorTexture>>
      known_;
};

}  // namespace

std::vector<render::Look> material_looks(const std::vector<MaterialLook>& looks,
                                         const std::string& input,
                                         std::vector<std::string>& warnings,
                                         const Context& context) {
  if (std::none_of(looks.begin(), looks.end(), says_something)) return {};
  TextureReader textures(input, warnings, context);
  std::vector<render::Look> shown;
  for (const MaterialLook& look : looks) {
    const Color& c = look.base_color;
    shown.push_back({{c[0], c[1], c[2]},
                     textures.of(look),
                     look.texture_place.cast<float>(),
                     look.alpha,
                     c[3],
                     look.alpha_cutoff,
                     look.transmission});
  }
  return shown;
}

}  // namespace craze
