// What the header of a PLY file says besides its data.
#pragma once

#include <string>
#include <vector>

#include "craze/io/source_scene.h"

namespace craze {

struct PlyScene : SourceScene {
  std::vector<std::string> comments;  ///< behind "comment ", but for materials

  explicit PlyScene(std::vector<std::string> all) : comments(std::move(all)) {}
  std::vector<SceneContent> contents() const override { return {{"comments", comments}}; }
};

}  // namespace craze
