#include "craze/recipe/idle_keys.h"

#include "craze/base/text/format.h"

namespace craze {

namespace {

/// Those that only rough lines have a use for.
std::vector<std::string> keys_of_rough_lines(const PostParameters& post) {
  const PostParameters usual;
  std::vector<std::string> keys;
  if (post.roughness_exponent != usual.roughness_exponent) {
    keys.emplace_back("post.roughness_exponent");
  }
  if (post.roughness_step > 0) keys.emplace_back("post.roughness_step");
  return keys;
}

}  // namespace

std::vector<std::string> keys_of_solids(const PostParameters& post) {
  const PostParameters usual;
  std::vector<std::string> keys;
  if (post.wedge != usual.wedge) keys.emplace_back("post.wedge");
  if (post.core != usual.core) keys.emplace_back("post.core");
  if (post.collider != usual.collider) keys.emplace_back("post.collider");
  return keys;
}

std::vector<std::string> warnings_of_idle_keys(const PostParameters& post, bool has_cracks) {
  std::vector<std::string> warnings;
  const auto warn = [&](const char* why, const std::vector<std::string>& keys, const char* give) {
    if (!keys.empty()) {
      warnings.push_back(fmt::format("{} ({}): {}", why, fmt::join(keys, ", "), give));
    }
  };
  const bool has_solids = post.thickness != 0, has_gaps = post.gap != 0;
  if (!has_solids) {
    warn("there are no solid pieces", keys_of_solids(post), "give post.thickness");
  }
  if (post.roughness == 0 && post.relative_roughness == 0) {
    warn("lines are not rough", keys_of_rough_lines(post),
         "give post.roughness or post.relative_roughness");
  }
  if (post.chip_size > 0 && post.chipping == 0) {
    warn("nothing is chipped", {"post.chip_size"}, "give post.chipping");
  }
  if (has_cracks && post.curl != 0 && !has_gaps && !has_solids) {
    warn("the cracks are shut and no rims curl", {"post.curl"},
         "maps show it; for a mesh give post.gap or post.gap_width");
  }
  if (!has_gaps && post.chipping > 0) {
    warn("the cracks are shut and have no rims to chip", {"post.chipping"},
         "maps show chips; for a mesh give post.gap or post.gap_width");
  }
  if (post.face_roughness > 0 && post.wall == 0 && !has_solids) {
    warn("there are no faces to be rough", {"post.face_roughness"},
         "give post.wall or post.thickness");
  } else if (post.face_roughness > 0 && !has_gaps && !has_solids) {
    warn("the cracks are shut and nobody sees their rough faces", {"post.face_roughness"},
         "give post.gap, post.gap_width or post.thickness");
  }
  return warnings;
}

}  // namespace craze
