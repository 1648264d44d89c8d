#include "craze/products.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "craze/engine/cracked_surface.h"
#include "craze/products/cut_surface.h"
#include "craze/products/growth/growth.h"
#include "craze/products/opening/opened_origin.h"
#include "craze/products/opening/opened_surface.h"
#include "craze/products/report_json.h"
#include "craze/products/statistics/graph/simplify_lines.h"

namespace craze {

namespace {

StatisticsWithSensitivity statistics_of(const CrackGraphInput& graph, const Context& context) {
  StatisticsOptions options;
  options.bootstrap.context = context;
  return compute_with_sensitivity(graph, options);
}

StatisticsWithSensitivity statistics_of(const CrackedSurface& state, const Context& context) {
  return statistics_of(graph_from_network(state.network, state.mesh()), context);
}

}  // namespace

struct Opening::State {
  Result result;
  OpenedSurface surface;
};

struct GrowthClip::State {
  std::shared_ptr<const Opening::State> opening;
  Growth growth;
};

SurfaceMesh cut_mesh(const Result& result, const Context& context) {
  return cut_surface(result, growth_times(result), context);
}

Opening::Opening(const Result& result, const PostParameters& post, const Context& context) {
  GrowthTimes times = growth_times(result);
  SurfaceMesh cut = cut_surface(result, times, context);
  state_ = std::make_shared<const State>(
      State{result, opened_surface(result, std::move(cut), std::move(times), post, context)});
}

const SurfaceMesh& Opening::mesh() const {
  return state_->surface.mesh;
}

SurfaceOrigin Opening::origin() const {
  return opened_origin(state_->result, state_->surface);
}

const std::vector<std::string>& Opening::warnings() const {
  return state_->surface.warnings;
}

const Result& Opening::result() const {
  return state_->result;
}

const OpenedSurface& Opening::surface() const {
  return state_->surface;
}

GrowthClip::GrowthClip(const Opening& opening)
    : state_(std::make_shared<const State>(
          State{opening.state_, {opening.state_->result, opening.state_->surface}})) {}

std::vector<Vec3> GrowthClip::positions_at(double time) const {
  return state_->growth.positions_at(time);
}

std::vector<double> GrowthClip::openness_at(double time) const {
  return state_->growth.openness_at(time);
}

std::string report_json(const Result& result, const Context& context) {
  const CrackedSurface& state = result.state();
  if (state.network.edges.empty()) return report_text(result.report(), nullptr);
  const StatisticsWithSensitivity statistics = statistics_of(state, context);
  return report_text(result.report(), &statistics);
}

std::string statistics_json(const Result& result, const Context& context) {
  if (result.state().network.edges.empty()) return "{}";
  return to_json(statistics_of(result.state(), context), {}).dump(2);
}

std::string statistics_json(const LineSet& lines, double simplify, const Context& context) {
  CrackGraphInput graph = graph_from_lines(lines);
  simplify_lines(graph, simplify);
  return to_json(statistics_of(graph, context), {}).dump(2);
}

}  // namespace craze
