#include "craze/engine/tile.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "craze/base/text/format.h"
#include "craze/engine/check_where.h"
#include "craze/engine/place_impacts.h"
#include "craze/engine/run_outcome.h"
#include "craze/engine/spacing_rounds.h"
#include "craze/error.h"
#include "craze/mesh/bounding_diagonal.h"
#include "craze/mesh/shapes/periodic_square.h"
#include "craze/model/screening.h"
#include "craze/recipe/check_recipe.h"
#include "craze/recipe/idle_keys.h"
#include "craze/recipe/length_text.h"
#include "craze/recipe/own_lengths.h"

namespace craze {

namespace {

// Of the side: what is looked at together must be nearer than half of it.
constexpr double longest_reach = 0.25;
// Of the side, where no length of the recipe says what edge the pattern needs.
constexpr double free_edge = 0.01;
// Edges of the mesh that is remeshed, over those that are wanted.
constexpr double coarse = 4;
constexpr int fewest_cells = 4;

void check_reach(double length, const char* key, double side) {
  if (length <= longest_reach * side) return;
  throw Error(ErrorKind::request, "tile too small for its pattern", key,
              fmt::format("{:.3g} is more than a quarter of the tile, {:.3g}: cracks would meet "
                          "their own images; give a longer period or a smaller spacing",
                          length, side));
}

void check_reaches(const SimulationParameters& p, double side) {
  check_reach(p.layer.screening_length, "layer.spacing", side);
  check_reach(process_zone(p.material, p.layer), "material.process_zone", side);
  check_reach(p.material.lookahead, "material.lookahead", side);
}

/// The recipe of the run: a tile has no triangles of its own to keep.
Recipe for_tile(Recipe recipe, double screening_length, double side) {
  EdgeLength& edge = recipe.mesh.edge;
  if (edge.kind == EdgeLength::Kind::keep) edge = {};
  if (edge.kind == EdgeLength::Kind::automatic && screening_length == 0) {
    edge = {EdgeLength::Kind::given, free_edge * side};
  }
  recipe.mesh.output = OutputMesh::simulation;
  return recipe;
}

/// A square that is coarser than any mesh that the recipe may ask for.
SurfaceMesh coarse_square(const Recipe& recipe, double screening_length, double side) {
  const bool given = recipe.mesh.edge.kind == EdgeLength::Kind::given;
  const double edge = given ? static_cast<double>(recipe.mesh.edge.length) : screening_length / 4;
  if (given) check_reach(coarse * edge, "mesh.edge", side);
  const double cells = std::floor(side / (coarse * edge));
  return periodic_square(side, std::max(fewest_cells, static_cast<int>(std::min(cells, 1e3))));
}

/// Makes the cracks' lines rough, where the recipe asks for that.
void roughen_tile(CrackedTile& tile, const Context& context) {
  resolve_roughness(tile.recipe.post, tile.network);
  if (!(tile.recipe.post.roughness > 0)) return;
  const RoughNetwork rough = roughen(tile.network, tile.simulation->mesh(),
                                     roughness_options(tile.recipe, *tile.simulation), context);
  warn_of_roughness(tile.report, tile.recipe, rough);
  tile.rough =
      std::make_shared<const CrackedAsset>(carry_onto_plane(tile.surface, rough.network, context));
  tile.network = tile.rough->network;
}

/// Of keys that only a mesh has a use for.
void warn_of_idle_keys(Report& report, const Recipe& recipe) {
  std::vector<std::string> keys = keys_of_solids(recipe.post);
  if (recipe.post.thickness.number() > 0) keys.insert(keys.begin(), "post.thickness");
  if (recipe.mesh.edge.kind == EdgeLength::Kind::keep) keys.insert(keys.begin(), "mesh.edge");
  if (keys.empty()) return;
  report.warnings.push_back(fmt::format("a tile is flat and in one piece: what does nothing ({})",
                                        fmt::join(keys, ", ")));
}

}  // namespace

TileSize read_tile_size(const std::string& period) {
  const std::optional<Length> length = parse_length(period);
  const bool is_size = length && length->unit() != LengthUnit::percent && length->number() > 0;
  if (!is_size) {
    throw Error(ErrorKind::usage, "wrong period", period,
                "give a length above 0, such as 2 or 40cm");
  }
  if (length->unit() == LengthUnit::own) return {length->number(), 0};
  return {length->number() * metres(length->unit()), 1};
}

CrackedTile crack_tile(const Recipe& recipe, const TileSize& size, const Context& context) {
  const auto start = std::chrono::steady_clock::now();
  if (!(size.side > 0) || !std::isfinite(size.side)) {
    throw Error(ErrorKind::request, "bad tile", fmt::format("{}", size.side),
                "its side must be a positive number");
  }
  CrackedTile tile;
  Report& report = tile.report;
  report.recipe = recipe;
  report.threads = context.threads.count();
  check_recipe(recipe);
  const Period period{size.side};
  SurfaceMesh square = periodic_square(size.side, fewest_cells);
  square.metres_per_unit = size.metres_per_unit;
  check_where(square, recipe.simulation.where);
  const double diagonal = bounding_diagonal({}, period);
  report.recipe =
      with_own_lengths(report.recipe, {diagonal, metres_per_unit(square, report.recipe)});
  SimulationParameters& parameters = report.recipe.simulation;
  const SimulationParameters resolved = resolve_lengths(parameters, diagonal);
  check_reaches(resolved, size.side);
  report.recipe = for_tile(report.recipe, resolved.layer.screening_length, size.side);
  square = coarse_square(report.recipe, resolved.layer.screening_length, size.side);
  parameters.impacts = place_impacts(std::move(parameters.impacts), square, context, period);
  context.report({"prepare"});
  context.check();

  SpacedRun run = run_to_spacing(std::move(square), report.recipe, {}, context, {}, period);
  if (run.last.reason == StopReason::cancelled) throw Cancelled();
  tile.recipe = std::move(run.recipe);
  tile.surface = std::move(run.surface.mesh);
  tile.simulation = std::move(run.last.simulation);
  tile.network = crack_network(*tile.simulation);
  roughen_tile(tile, context);
  tile.fragments = find_components(tile.mesh());
  resolve_gap(tile.recipe.post, tile.network);

  const Simulation& simulation = *tile.simulation;
  const TriangleMesh& mesh = tile.mesh();
  report.recipe = tile.recipe;
  report.simulation = count_mesh(tile.surface);
  report.output = {mesh.vertex_count(), mesh.face_count()};
  report.cracks = {simulation.events(), simulation.segments(), total_length(tile.network),
                   tile.fragments.count};
  report.stop_reason = to_string(run.last.reason);
  report.load = simulation.load();
  add_run_warnings(report, run.last, simulation);
  warn_of_idle_keys(report, recipe);
  report.time.total =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return tile;
}

}  // namespace craze
