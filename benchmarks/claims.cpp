// Prints the table of docs/claims.md: what the paper says of its cracks, measured over seeds.
#include <fmt/format.h>

#include <functional>

#include "craze/scenario/figure_table.h"
#include "scenario/claims.h"

namespace craze {
namespace {

constexpr std::uint64_t seeds = 5;

struct Sample {
  double mean = 0, deviation = 0;
};

Sample over_seeds(const std::function<double(std::uint64_t)>& measure) {
  Sample sample;
  double squares = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const double x = measure(seed);
    sample.mean += x / seeds;
    squares += x * x / seeds;
  }
  sample.deviation =
      std::sqrt(std::max(0.0, squares - sample.mean * sample.mean) * (seeds / (seeds - 1.0)));
  return sample;
}

void row(const std::string& claim, const std::string& setting, const Sample& s, int digits) {
  fmt::print("| {} | {} | {:.{}f} ± {:.{}f} |\n", claim, setting, s.mean, digits, s.deviation,
             digits);
  std::fflush(stdout);
}

void measure_alpha(const std::string& engine, Recipe recipe) {
  for (const double alpha : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    recipe.simulation.material.alpha = alpha;
    Sample turn;
    const Sample length = over_seeds([&](std::uint64_t seed) {
      const test::Cracked cracked = test::crack("plate?n=60&jitter=0.3", recipe, seed);
      turn.mean += test::mean_turn(cracked.simulation.network()) / seeds;
      return test::tortuosity(cracked);
    });
    row("length over chord, " + engine, fmt::format("α = {}", alpha), length, 4);
    fmt::print("| turn between crack edges, {} | α = {} | {:.1f}° |\n", engine, alpha, turn.mean);
  }
}

void measure_density() {
  for (const CurvatureScale scale :
       {CurvatureScale::none, CurvatureScale::frobenius, CurvatureScale::sum_of_squares}) {
    Recipe recipe = test::coarse_preset("glaze", 0.06);
    recipe.simulation.material.curvature_scale = scale;
    row("density, most curved quarter over flattest",
        std::vector<std::string>{"none", "", "", "frobenius",
                                 "sum-of-squares"}[static_cast<int>(scale)],
        over_seeds([&](std::uint64_t seed) {
          return test::density_contrast(test::crack("bumps?n=30", recipe, seed));
        }),
        2);
  }
}

void measure_bias() {
  for (const double bias : {0.0, 0.5, 1.0}) {
    Recipe recipe = test::coarse_preset("glaze", 0.06);
    recipe.simulation.material.bias = bias;
    row("⟨cos 2θ⟩ to the principal direction", fmt::format("bias = {}", bias),
        over_seeds([&](std::uint64_t seed) {
          return test::alignment(test::crack("drape?n=120", recipe, seed));
        }),
        3);
  }
}

void measure_border() {
  for (const BoundaryKind kind : {BoundaryKind::free, BoundaryKind::fixed}) {
    Recipe recipe = test::coarse_preset("mud", 0.1);
    recipe.simulation.boundary.kind = kind;
    row("degrees off the border's normal", kind == BoundaryKind::free ? "free" : "fixed",
        over_seeds([&](std::uint64_t seed) {
          return test::off_border_normal(test::crack("plate?n=60&jitter=0.3", recipe, seed), 0.05);
        }),
        1);
  }
}

void measure_impact() {
  const Recipe recipe = read_recipe(find_figure_recipe("glass").text, "recipes/figures/glass.toml");
  row("rings open when half of the rays are, share", "recipes/figures/glass.toml",
      over_seeds([&](std::uint64_t seed) {
        return test::rings_before_half_the_rays(test::crack("plate?n=49&jitter=0.3", recipe, seed),
                                                recipe.simulation.impacts[0].point);
      }),
      2);
}

}  // namespace
}  // namespace craze

int main() {
  using namespace craze;
  fmt::print("| measured | setting | mean ± deviation over {} seeds |\n|---|---|---|\n", seeds);
  Recipe recipe = test::coarse_preset("mud", 0.1);
  measure_alpha("quasistatic", recipe);
  measure_density();
  measure_bias();
  measure_border();
  measure_impact();
}
