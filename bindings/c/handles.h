// What stands behind the opaque handles of craze.h.
#pragma once

#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "craze/craze.h"
#include "craze/engine.h"
#include "craze/line_set.h"
#include "craze/products.h"
#include "craze/recipe.h"
#include "craze/surface_mesh.h"

struct craze_mesh {
  std::shared_ptr<craze::SurfaceMesh> mesh;
  std::vector<std::string> names;  // of its arrays

  explicit craze_mesh(craze::SurfaceMesh given);
};

struct craze_lines {
  craze::LineSet lines;
};

struct craze_job {
  std::shared_ptr<const craze::SurfaceMesh> mesh;
  craze::Textures textures;
  craze::Recipe recipe;
  craze::CrackOptions options;
  int threads = 0;
  craze_progress progress = nullptr;
  void* user = nullptr;
  std::optional<craze::Result> result;
};

struct craze_opening {
  craze::Opening opening;
  std::optional<craze::GrowthClip> clip;  // made when the first position is asked for
};
