// Prints the table of docs/claims.md: what the paper says of its cracks, measured over seeds.

#include <functional>

#include "craze/base/text/format.h"
#include "craze/job/figure_table.h"
#include "craze/model/crack_network.h"
#include "craze/read_mesh.h"
#include "engine/claims.h"

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

/// One line of the table; `holds` is what the paper's words ask of it.
void row(const std::string& measured, const std::string& setting, const Sample& s, int digits,
         bool holds) {
  fmt::print("| {} | {} | {:.{}f} ± {:.{}f} | {} |\n", measured, setting, s.mean, digits,
             s.deviation, digits, holds ? "yes" : "**no**");
  std::fflush(stdout);
}

void measure_alpha(const std::string& engine, const std::string& shape, Recipe recipe) {
  Sample longer{1e9, 0}, sharper{1e9, 0};
  for (const double alpha : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    recipe.simulation.material.alpha = alpha;
    std::vector<double> lengths;
    const Sample turn = over_seeds([&](std::uint64_t seed) {
      const test::Cracked cracked = test::crack(shape, recipe, seed);
      lengths.push_back(test::tortuosity(cracked));
      return test::mean_turn(crack_network(cracked.simulation));
    });
    const Sample length = over_seeds([&](std::uint64_t seed) { return lengths[seed - 1]; });
    const std::string setting = fmt::format("α = {}, {}", alpha, engine);
    row("length of cracks over their chord", setting, length, 4, length.mean < longer.mean);
    row("turn from one crack edge to the next, degrees", setting, turn, 1,
        turn.mean < sharper.mean);
    longer = length;
    sharper = turn;
  }
}

void measure_density(const std::string& name, const SurfaceMesh& mesh) {
  for (const auto& [scale, words] : {std::pair(CurvatureScale::none, "uniform"),
                                     std::pair(CurvatureScale::frobenius, "frobenius"),
                                     std::pair(CurvatureScale::sum_of_squares, "sum-of-squares")}) {
    Recipe recipe = read_recipe(find_figure_recipe("bunny_curvature").text, "");
    recipe.simulation.material.curvature_scale = scale;
    const Sample s = over_seeds([&](std::uint64_t seed) {
      return test::density_contrast(test::crack(mesh, recipe, seed));
    });
    row("crack density, most curved quarter over flattest", fmt::format("{}, {}", words, name), s,
        2, scale == CurvatureScale::none ? std::abs(s.mean - 1) < 0.15 : s.mean >= 2);
  }
}

void measure_bias() {
  double before = -1;
  for (const double bias : {0.0, 0.5, 1.0}) {
    Recipe recipe = test::coarse_preset("glaze", 0.06);
    recipe.simulation.material.bias = bias;
    const Sample s = over_seeds([&](std::uint64_t seed) {
      return test::alignment(test::crack("drape?n=120", recipe, seed));
    });
    row("⟨cos 2θ⟩, θ to the principal direction", fmt::format("bias = {}", bias), s, 3,
        s.mean > before);
    before = s.mean;
  }
}

void measure_border() {
  for (const BoundaryKind kind : {BoundaryKind::free, BoundaryKind::fixed}) {
    Recipe recipe = test::coarse_preset("mud", 0.1);
    recipe.simulation.boundary.kind = kind;
    const Sample s = over_seeds([&](std::uint64_t seed) {
      return test::off_border_normal(test::crack("plate?n=60&jitter=0.3", recipe, seed), 0.05);
    });
    // Directions drawn at random would be 45° off.
    row("degrees off the border's normal", kind == BoundaryKind::free ? "free" : "fixed", s, 1,
        kind == BoundaryKind::free ? s.mean < 15 : s.mean > 20);
  }
}

void measure_impact() {
  const Recipe recipe = read_recipe(find_figure_recipe("glass").text, "");
  const Sample s = over_seeds([&](std::uint64_t seed) {
    return test::rings_before_half_the_rays(test::crack("plate?n=49&jitter=0.3", recipe, seed),
                                            recipe.simulation.impacts[0].point);
  });
  row("share of the rings open when half of the rays are", "Fig. 3", s, 2, s.mean < 0.5);
}

void measure_moves() {
  for (const Engine engine : {Engine::quasistatic, Engine::euler}) {
    Recipe recipe = test::coarse_preset("mud", 0.15);
    recipe.simulation.engine = engine;
    recipe.simulation.crack.near_vertex = NearVertex::snap;
    recipe.simulation.evolution.shrinkage = 0.001;
    const Sample s = over_seeds([&](std::uint64_t seed) {
      return test::farthest_move(test::crack("plate?n=30&jitter=0.3", recipe, seed));
    });
    row("farthest move of a node, of the diagonal",
        engine == Engine::euler ? "euler" : "quasistatic", s, 0, s.mean == 0);
  }
}

}  // namespace
}  // namespace craze

int main(int argc, char** argv) {
  using namespace craze;
  fmt::print("| measured | setting | mean ± deviation over {} seeds | holds |\n|---|---|---|---|\n",
             seeds);
  Recipe mud = test::coarse_preset("mud", 0.1);
  mud.simulation.material.relative_lookahead = 0;  // the paper's tips turn by ς alone
  measure_alpha("quasistatic", "plate?n=60&jitter=0.3", mud);
  measure_density("shape:bumps", make_shape("bumps?n=30"));
  if (argc > 1)
    measure_density("bunny_51k.obj", read_mesh_file(std::string(argv[1]) + "/bunny_51k.obj").mesh);
  measure_bias();
  measure_border();
  measure_impact();
  measure_moves();
  Recipe stepped = read_recipe(find_figure_recipe("mud_by_force").text, "");
  stepped.simulation.layer.relative_spacing = 0.14;
  stepped.simulation.material.toughness = 0.024;  // edges twice as long as the recipe's
  measure_alpha("euler by force", "plate?n=50&jitter=0.3", stepped);
}
