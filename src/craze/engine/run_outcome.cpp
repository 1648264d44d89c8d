#include "craze/engine/run_outcome.h"

#include <cmath>

#include "craze/base/text/format.h"
#include "craze/engine/roughness/crack_chains.h"
#include "craze/engine/spacing_rounds.h"
#include "craze/engine/width_by_age.h"

namespace craze {

namespace {

constexpr double told_from = 0.1;  // of the length of the cracks: what is seen

}  // namespace

void resolve_gap(PostParameters& post, const CrackNetwork& network) {
  if (!(post.gap_width > 0)) return;
  double length = 0, opening = 0;  // of Eq. 9 with γ = 1, times the length
  const WidthByAge by_age = width_by_age(post.late_width, network.edges);
  for (const CrackEdge& e : network.edges) {
    const double of_edge = network.length(e);
    length += of_edge;
    opening += of_edge * e.width * by_age.factor(e.time);
  }
  if (opening > 0) post.gap = post.gap_width * (length / opening);
  post.gap_width = 0;
}

void resolve_roughness(PostParameters& post, const CrackNetwork& network) {
  if (post.roughness > 0 || !(post.relative_roughness > 0)) return;
  post.roughness = post.relative_roughness * usual_length(crack_chains(network));
}

RoughnessOptions roughness_options(const Recipe& recipe, const Simulation& simulation) {
  const PostParameters& post = recipe.post;
  RoughnessOptions options{post.roughness, post.roughness_exponent, post.roughness_step,
                           recipe.simulation.seed};
  for (const double scale : simulation.toughness_scale()) {
    options.closed.push_back(std::isinf(scale) ? 1 : 0);
  }
  return options;
}

void warn_of_roughness(Report& report, const Recipe& recipe, const RoughNetwork& rough) {
  if (rough.held_back > told_from) {
    report.warnings.push_back(
        fmt::format("cracks are less rough than asked for (post.roughness) along {:.0f} % of their "
                    "length: others, or bends of their own, are too near",
                    100 * rough.held_back));
  }
  if (rough.step > recipe.post.roughness_step && recipe.post.roughness_step > 0) {
    report.warnings.push_back(
        fmt::format("the points of rough cracks lie up to {:.3g} apart, not {:.3g} "
                    "(post.roughness_step): finer, they would be more than {:.0f}, or the lines "
                    "steeper than 45 degrees",
                    rough.step, static_cast<double>(recipe.post.roughness_step), most_points));
  }
}

void add_run_warnings(Report& report, const LastCycle& last, const Simulation& simulation) {
  if (last.closed) {
    report.warnings.push_back("nothing can crack (where): it leaves no triangle of the surface");
  }
  if (last.unstressed) {
    // In equilibrium from the start: not wrong, but seldom what was wanted.
    report.warnings.push_back(
        "nothing can crack (stress): it is zero everywhere; give stress.uniform, an impact or a "
        "painted stress that is not");
  }
  if (last.unloaded) {
    report.warnings.push_back(
        "nothing can crack (evolution.max_load): no place starts to be loaded before it; give "
        "more, "
        "or less onset");
  }
  if (!simulation.met_tolerance()) {
    report.warnings.push_back(
        "equilibrium was not always reached (evolution.residual): double precision ends before it; "
        "cracks may open a little too early or late");
  }
  if (report.carried.lost_pieces > 0) {
    report.warnings.push_back(fmt::format(
        "{} pieces of crack, {:.2g} of {:.3g} long, found no way over the input's triangles "
        "(mesh.output): gaps or folds lie between their ends",
        report.carried.lost_pieces, report.carried.lost_length,
        report.carried.lost_length + report.cracks.length));
  }
  const bool ended = last.reason == StopReason::equilibrium || last.reason == StopReason::max_load;
  if (ended && report.cracks.segments == 0) {
    if (!last.closed && !last.unstressed && !last.unloaded) {
      report.warnings.push_back(
          "no crack opened (stress): the surface holds; start from a preset, or give more stress, "
          "more evolution.max_load, or less layer.spacing than parts are large");
    }
    return;
  }
  const bool whole = !report.recipe.simulation.where.is_given() && !last.staggered;
  if (whole && ended) {
    if (const auto warning = spacing_warning(report.recipe.simulation.layer, simulation.mesh(),
                                             report.cracks.fragments)) {
      report.warnings.push_back(*warning);
    }
  }
}

}  // namespace craze
