#include "craze/job/maps/bake_settings.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "craze/error.h"
#include "craze/mesh/bounding_diagonal.h"
#include "craze/recipe/check_recipe.h"
#include "craze/recipe/own_lengths.h"

namespace craze {

namespace {

/// What grooves are made of besides the lines, which are as the file has them.
constexpr std::array<std::string_view, 8> keys{"post.gap",        "post.gap_width", "post.wall",
                                               "post.late_width", "post.curl",      "post.chipping",
                                               "post.chip_size",  "mesh.unit"};

}  // namespace

std::string bake_keys() {
  std::string names;
  for (const std::string_view key : keys) {
    names += (names.empty() ? "" : ", ") + std::string(key);
  }
  return names;
}

void apply_bake_set(Recipe& recipe, const std::string& assignment) {
  const std::string key = assignment.substr(0, assignment.find('='));
  apply_set(recipe, assignment);  // which knows what is no key at all
  if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
    throw Error(ErrorKind::usage, "cannot be set for a mesh that is cracked already",
                "--set " + assignment, "what can: " + bake_keys());
  }
}

PostParameters bake_post(const Recipe& recipe, const SurfaceMesh& mesh) {
  check_recipe(recipe);
  return with_own_lengths(recipe,
                          {bounding_diagonal(mesh.positions), metres_per_unit(mesh, recipe)})
      .post;
}

}  // namespace craze
