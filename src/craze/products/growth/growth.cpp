#include "craze/products/growth/growth.h"

#include <utility>
namespace craze {

Growth::Growth(const Result& result, const OpenedSurface& opened)
    : opened_(opened),
      motion_(opened.base(result), opened.times.sites, opened.times.schedule, opened.opened) {}

std::vector<double> Growth::openness_at(double time) const {
  std::vector<double> openness;
  openness.reserve(opened_.opened.vertex_of.size());
  for (const std::int32_t v : opened_.opened.vertex_of) {
    const std::int32_t site = opened_.times.sites.site_of[v];
    openness.push_back(
        site < 0 ? 0 : CrackSchedule::openness(opened_.times.schedule.sites[site], time));
  }
  return openness;
}

std::vector<std::array<float, 2>> Growth::side_openness_at(double time) const {
  std::vector<std::array<float, 2>> open;
  open.reserve(opened_.times.schedule.sides.size());
  for (const auto& [from, to] : opened_.times.schedule.sides) {
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
