#include "craze/products/growth/growth.h"

#include <utility>

#include "craze/engine/cracked_surface.h"

namespace craze {

Growth::Growth(const Result& result, const GrowthTimes& times, const OpenedSurface& opened)
    : times_(times),
      opened_(opened),
      motion_(result.state().simulation->mesh(), times.sites, times.schedule, opened.opened) {}

std::vector<double> Growth::openness_at(double time) const {
  std::vector<double> openness;
  openness.reserve(opened_.opened.vertex_of.size());
  for (const std::int32_t v : opened_.opened.vertex_of) {
    const std::int32_t site = times_.sites.site_of[v];
    openness.push_back(site < 0 ? 0 : CrackSchedule::openness(times_.schedule.sites[site], time));
  }
  return openness;
}

std::vector<std::array<float, 2>> Growth::side_openness_at(double time) const {
  std::vector<std::array<float, 2>> open;
  open.reserve(times_.schedule.sides.size());
  for (const auto& [from, to] : times_.schedule.sides) {
    open.push_back({static_cast<float>(CrackSchedule::openness(from, time)),
                    static_cast<float>(CrackSchedule::openness(to, time))});
  }
  return open;
}

MorphAnimation Growth::animation(int stages, double seconds, const Context& context) const {
  MorphAnimation animation;
  animation.seconds = seconds;
  std::vector<Vec3> before = motion_.positions(0);
  for (int k = 1; k <= stages; ++k) {
    context.report({"animate", static_cast<double>(k) / stages});
    context.check();
    std::vector<Vec3> now = motion_.positions(static_cast<double>(k) / stages);
    MorphStage& stage = animation.stages.emplace_back();
    for (std::size_t v = 0; v < now.size(); ++v) {
      if (now[v] == before[v]) continue;
      stage.vertices.push_back(static_cast<std::int32_t>(v));
      stage.shifts.push_back(now[v] - before[v]);
    }
    before = std::move(now);
  }
  return animation;
}

}  // namespace craze
