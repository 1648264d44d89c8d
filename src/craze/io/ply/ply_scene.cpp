#include "craze/io/ply/ply_scene.h"

#include <algorithm>

#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/files/bring_picture.h"
#include "craze/io/files/file_names.h"

namespace craze {

namespace {

namespace fs = std::filesystem;

const std::string texture_key = "TextureFile ";

/// As header lines name materials: without the folders and the ending.
std::string material_name(const std::string& texture) {
  const std::string stem = fs::path(plain_file_name(texture)).stem().string();
  return stem.empty() ? "texture" : stem;
}

MaterialLook wall_look() {
  constexpr float grey = 0.25f;
  MaterialLook look;
  look.base_color = {grey, grey, grey, 1};
  return look;
}

}  // namespace

std::vector<SceneContent> PlyScene::contents() const {
  SceneContent said{"comments", {}}, shown{"pictures of materials", {}},
      named{"textures that were not read", {}};
  for (const std::string& comment : comments) {
    if (looks.empty() || !comment.starts_with(texture_key)) said.names.push_back(comment);
  }
  for (const std::string& texture : looks.empty() ? std::vector<std::string>() : textures) {
    (pictures.count(plain_file_name(texture)) ? shown : named).names.push_back(texture);
  }
  std::vector<SceneContent> all{said, {"obj_info lines", infos}, shown, named};
  std::erase_if(all, [](const SceneContent& content) { return content.names.empty(); });
  return all;
}

std::shared_ptr<const PlyScene> PlyScene::seen_from(const fs::path& path) const {
  const fs::path from = whole_path(folder), to = whole_path(path.parent_path());
  auto moved = std::make_shared<PlyScene>(*this);
  if (from == to) return moved;
  for (std::string& comment : moved->comments) {
    if (!comment.starts_with(texture_key)) continue;
    const std::string name = plain_file_name(comment.substr(texture_key.size()));
    if (is_absolute_name(name)) continue;
    comment = texture_key + (from / name).lexically_proximate(to).generic_string();
  }
  return moved;
}

std::vector<std::string> texture_materials(const PlyHeader& header) {
  std::vector<std::string> names;
  for (const std::string& texture : header.textures) {
    const std::string wanted = material_name(texture);
    std::string name = wanted;
    for (int n = 2; std::find(names.begin(), names.end(), name) != names.end(); ++n) {
      name = fmt::format("{}_{}", wanted, n);
    }
    names.push_back(std::move(name));
  }
  return names;
}

void bring_textures(const std::vector<std::string>& materials, const PlyHeader& header,
                    const MeshSource& source, PlyScene& scene) {
  if (header.textures.empty()) return;
  scene.textures = header.textures;
  if (materials.empty()) {
    // Without UVs it is a picture of all faces for those who can place it.
    if (!source.looks || header.textures.size() > 1) return;
    MaterialLook whole;
    whole.base_picture.file = plain_file_name(header.textures[0]);
    source.looks->assign(1, whole);
    return;
  }
  const std::vector<std::string> own = texture_materials(header);
  for (const std::string& material : materials) {
    MaterialLook look;
    const auto found = std::find(own.begin(), own.end(), material);
    const auto number = static_cast<std::size_t>(found - own.begin());
    if (found != own.end()) {
      look.base_picture.file = plain_file_name(header.textures[number]);
    } else if (material == "crack_wall") {
      look = wall_look();
    } else if (header.textures.size() == 1) {
      look.base_picture.file = plain_file_name(header.textures[0]);
    }
    scene.looks.push_back(std::move(look));
  }
  if (!source.files) return;
  for (const std::string& texture : header.textures) {
    const std::string name = plain_file_name(texture);
    BroughtPicture picture = bring_picture(name, source);
    if (picture.why.empty()) {
      scene.pictures[name] = std::move(picture.bytes);
    } else {
      source.warn(fmt::format("texture '{}' cannot be read: {}", printable(name), picture.why));
    }
  }
}

}  // namespace craze
