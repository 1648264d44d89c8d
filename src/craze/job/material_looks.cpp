#include "craze/job/material_looks.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/files/sibling_files.h"
#include "craze/io/gltf/scene/uvs/uv_sets.h"
#include "craze/io/image/read_image.h"

namespace craze {

namespace {

/// What is read for one purpose, and where.
struct ReadPicture {
  const LookPicture* picture;
  std::size_t uv_set = 0;
  float factor = 1;  ///< of transmission

  explicit operator bool() const { return static_cast<bool>(*picture); }
};

ReadPicture picture_of(const MaterialLook& look, LookPicture MaterialLook::*slot, ShownUvs uvs) {
  for (const FurtherPicture& f : look.further) {
    if (uvs == ShownUvs::all && f.slot == slot) return {&f.picture, f.uv_set, f.factor};
  }
  return {&(look.*slot), 0, look.transmission};
}

bool says_something(const MaterialLook& look, ShownUvs uvs) {
  const auto has = [&](LookPicture MaterialLook::*slot) -> bool {
    return static_cast<bool>(picture_of(look, slot, uvs));
  };
  const Color& c = look.base_color;
  return has(&MaterialLook::base_picture) || has(&MaterialLook::normal_picture) || c[0] != c[1] ||
         c[1] != c[2] || look.transmission > 0 || has(&MaterialLook::transmission_picture) ||
         look.alpha != MaterialLook::Alpha::ignored;
}

class TextureReader {
 public:
  TextureReader(const std::string& input, std::vector<std::string>& warnings,
                const Context& context)
      : input_(input), warnings_(warnings), context_(context) {}

  render::PlacedTexture of(const ReadPicture& read, render::Encoding encoding) {
    const LookPicture& picture = *read.picture;
    return {texture(picture, encoding), picture.place.cast<float>(), picture.wraps, read.uv_set};
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
                                         std::vector<std::string>& warnings, const Context& context,
                                         ShownUvs uvs) {
  if (uvs == ShownUvs::first &&
      std::any_of(looks.begin(), looks.end(),
                  [](const MaterialLook& look) { return !look.further.empty(); })) {
    warnings.emplace_back("textures that lie in a further UV set are not shown in pictures");
  }
  if (std::none_of(looks.begin(), looks.end(),
                   [&](const MaterialLook& look) { return says_something(look, uvs); })) {
    return {};
  }
  TextureReader textures(input, warnings, context);
  std::vector<render::Look> shown;
  using render::Encoding;
  for (const MaterialLook& look : looks) {
    const Color& c = look.base_color;
    render::Look& one = shown.emplace_back();
    one.color = {c[0], c[1], c[2]};
    one.picture = textures.of(picture_of(look, &MaterialLook::base_picture, uvs), Encoding::srgb);
    one.alpha = look.alpha;
    one.opacity = c[3];
    one.cutoff = look.alpha_cutoff;
    const ReadPicture through = picture_of(look, &MaterialLook::transmission_picture, uvs);
    one.transmission = through.factor;
    if (one.transmission > 0) {
      one.transmission_picture = textures.of(through, Encoding::linear);
      // One that cannot be read could have said that nothing is transmitted.
      if (through && !one.transmission_picture) one.transmission = 0;
    }
    one.normals =
        textures.of(picture_of(look, &MaterialLook::normal_picture, uvs), Encoding::linear);
    one.normal_strength = look.normal_strength;
  }
  return shown;
}

std::vector<std::vector<Vec2>> further_uvs(const MeshFile& file,
                                           std::vector<std::string>& warnings) {
  std::set<std::size_t> read;
  const auto* document = dynamic_cast<const GltfDocument*>(file.scene.get());
  std::vector<std::vector<Vec2>> sets;
  for (std::size_t m = 0; m < file.looks.size(); ++m) {
    for (const FurtherPicture& f : file.looks[m].further) read.insert(f.uv_set);
  }
  for (const std::size_t n : read) {
    const auto reads = [&](std::size_t m) {
      const auto& further = file.looks[m].further;
      return std::any_of(further.begin(), further.end(),
                         [&](const FurtherPicture& f) { return f.uv_set == n; });
    };
    UvSet set;
    if (document && n < most_uv_sets) set = uv_set(*document, n);
    const bool is_there = set.has.size() == file.mesh.triangles.size();
    std::size_t lack = 0;
    for (std::size_t f = 0; f < file.mesh.triangles.size(); ++f) {
      const std::int32_t m = file.mesh.face_materials.empty() ? 0 : file.mesh.face_materials[f];
      if (m < 0 || static_cast<std::size_t>(m) >= file.looks.size() || !reads(m)) continue;
      if (!is_there || !set.has[f]) ++lack;
    }
    if (lack > 0) {
      warnings.push_back(fmt::format(
          "textures read TEXCOORD_{}, which {} triangles of their materials have not", n, lack));
    }
    const bool any =
        is_there && std::any_of(set.has.begin(), set.has.end(), [](char has) { return has != 0; });
    if (!any) continue;
    if (sets.size() < n) sets.resize(n);
    sets[n - 1] = std::move(set.corners);
  }
  return sets;
}

}  // namespace craze
