#include "craze/recipe/check_recipe.h"

#include "craze/base/text/format.h"
#include "craze/error.h"

namespace craze {

namespace {

[[noreturn]] void fail(const std::string& what, const std::string& where, const char* why) {
  throw Error(ErrorKind::usage, what, where, why);
}

}  // namespace

void check_recipe(const Recipe& recipe) {
  const PostParameters& post = recipe.post;
  if (post.gap > 0 && post.gap_width.number() > 0) {
    fail("two openings", "post.gap_width", "post.gap is given too; set one of the two to 0");
  }
  const auto& impacts = recipe.simulation.impacts;
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    const Impact& impact = impacts[i];
    const int ways =
        !impact.point.isZero(0) + !impact.direction.isZero(0) + (impact.uv.empty() ? 0 : 1);
    if (ways > 1) {
      fail("two places", fmt::format("impact.{}", i), "give one of point, direction and uv");
    }
  }
}

}  // namespace craze
