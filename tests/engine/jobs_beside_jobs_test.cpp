// Nothing is global: runs in one process do not know of each other. ThreadSanitizer and
// LeakSanitizer look on where this is built with them.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "craze/engine.h"
#include "craze/presets.h"
#include "craze/products.h"
#include "craze/shapes.h"

namespace craze {
namespace {

struct Job {
  std::string shape, preset;
};

/// All that comes out of a run.
struct Outcome {
  std::vector<Vec3> cut, opened, halfway;
  std::string lines;

  bool operator==(const Outcome&) const = default;
};

Outcome run(const Job& job) {
  Context context;
  context.threads = 2;
  const auto surface = std::make_shared<const SurfaceMesh>(make_shape(job.shape));
  const Recipe recipe = read_preset(job.preset);
  const Result result = crack({surface, {}, job.shape}, recipe, {.max_cracks = 40}, context);
  const Opening opening(result, recipe.post, context);
  return {cut_mesh(result, context).positions, opening.mesh().positions,
          GrowthClip(opening).positions_at(0.5), statistics_json(result)};
}

TEST(JobsBesideJobs, TwoAtOnceMakeWhatEachMakesAlone) {
  const std::vector<Job> jobs{{"plate?n=16&jitter=0.3", "mud"}, {"cup?n=24", "glaze"}};
  const std::vector<Outcome> alone{run(jobs[0]), run(jobs[1])};
  std::vector<Outcome> together(2);
  std::thread other([&] { together[1] = run(jobs[1]); });
  together[0] = run(jobs[0]);
  other.join();
  EXPECT_TRUE(together == alone);
  EXPECT_GT(alone[0].cut.size(), 17u * 17u);
}

TEST(JobsBesideJobs, TenOneAfterTheOtherMakeTheSame) {
  const Job job{"plate?n=12&jitter=0.3", "mud"};
  const Outcome first = run(job);
  for (int i = 1; i < 10; ++i) EXPECT_TRUE(run(job) == first) << i;
}

}  // namespace
}  // namespace craze
