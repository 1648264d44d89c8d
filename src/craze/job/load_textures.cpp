#include "craze/job/load_textures.h"

#include "craze/io/image/read_image.h"

namespace craze {

Textures load_textures(const Recipe& recipe, const Context& context) {
  Textures textures;
  const SimulationParameters& p = recipe.simulation;
  for (const std::string* path : {&p.stress.texture, &p.material.texture, &p.layer.texture,
                                  &p.where.texture, &p.evolution.onset_texture}) {
    if (!path->empty() && !textures.count(*path)) {
      textures.emplace(*path, to_grey(read_image_file(*path, context)));
    }
  }
  return textures;
}

}  // namespace craze
