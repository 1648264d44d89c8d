#include "craze/job/load_textures.h"

#include <system_error>

#include "craze/error.h"
#include "craze/io/image/read_image.h"

namespace craze {

namespace fs = std::filesystem;

std::vector<NamedTexture> named_textures(const Recipe& recipe) {
  const SimulationParameters& p = recipe.simulation;
  std::vector<NamedTexture> named;
  for (const NamedTexture& texture : {NamedTexture{"stress.texture", p.stress.texture},
                                      {"material.texture", p.material.texture},
                                      {"layer.texture", p.layer.texture},
                                      {"where.texture", p.where.texture},
                                      {"evolution.onset_texture", p.evolution.onset_texture}}) {
    if (!texture.name.empty()) named.push_back(texture);
  }
  return named;
}

TextureFolder texture_folder(const fs::path& folder, const Recipe& recipe) {
  TextureFolder beside{folder, {}};
  for (const NamedTexture& texture : named_textures(recipe)) beside.names.insert(texture.name);
  return beside;
}

fs::path find_texture(const NamedTexture& texture, const TextureFolder& beside) {
  const fs::path from_here = texture.name;
  if (from_here.is_absolute() || !beside.names.count(texture.name)) return from_here;
  const fs::path near = (beside.folder / from_here).lexically_normal();
  std::error_code ignored;
  if (fs::exists(near, ignored)) return near;
  if (fs::exists(from_here, ignored)) return from_here;
  throw Error(ErrorKind::input, "no picture " + texture.name, texture.key,
              "it is neither " + near.string() + " nor in the working folder");
}

Textures load_textures(const Recipe& recipe, const TextureFolder& beside, const Context& context) {
  Textures textures;
  for (const NamedTexture& texture : named_textures(recipe)) {
    if (textures.count(texture.name)) continue;
    textures.emplace(texture.name,
                     to_grey(read_image_file(find_texture(texture, beside), context)));
  }
  return textures;
}

}  // namespace craze
