#include "craze/job/figure_table.h"

#include <algorithm>

#include "craze/error.h"
#include "craze/recipe/nearest_name.h"

namespace craze {

namespace {

// Shapes that stand in have about the triangles of the meshes they stand for.
constexpr std::string_view mud_plate = "shape:plate?n=99&jitter=0.3";

}  // namespace

const std::vector<Figure>& figure_table() {
  static const std::vector<Figure> table{
      {.number = 1,
       .name = "dragon",
       .title = "Crackle glass: uniform shrinkage",
       .recipes = {"dragon"},
       .mesh = "dragon_75k.obj",
       .shape = "shape:torus?n=285&major=0.09&minor=0.036",
       .azimuth = 25,
       .paper_triangles = 75000,
       .paper_time = "2.7 hours"},
      {.number = 2,
       .name = "statue",
       .title = "Uniform tension with a bias toward the principal directions of curvature",
       .recipes = {"statue"},
       .mesh = "lucy_100k.obj",
       .shape = "shape:drape?n=316&radius=450&height=1600",
       .azimuth = 10,
       .elevation = 8,
       .aspect = 1.5,
       .paper_triangles = 105772,
       .paper_time = "4.0 hours"},
      {.number = 3,
       .name = "glass",
       .title = "Struck flat glass: rays first, rings later",
       .recipes = {"glass"},
       .shape = "shape:plate?n=49&jitter=0.3",
       .azimuth = 0,
       .elevation = 62,
       .paper_triangles = 4804,
       .paper_time = "20 seconds"},
      {.number = 4,
       .name = "bunny",
       .title = "Cracks where the surface is curved, beside uniform shrinkage",
       .recipes = {"bunny_curvature", "bunny_uniform"},
       .mesh = "bunny_51k.obj",
       .shape = "shape:bumps?n=51",
       .azimuth = 20,
       .paper_triangles = 51382,
       .paper_time = "3.2 hours, 2.5 hours"},
      {.number = 5,
       .name = "snapping",
       .title = "Remeshing and snapping rules, drawn from mesh states",
       .kind = FigureKind::diagram},
      {.number = 6,
       .name = "teapot",
       .title = "Crackle glaze",
       .recipes = {"teapot"},
       .mesh = "teapot_60k.obj",
       .shape = "shape:bowl?n=288",
       .azimuth = 20,
       .elevation = 24,
       .paper_triangles = 60000,
       .paper_time = "4.9 hours"},
      {.number = 7,
       .name = "cup",
       .title = "Crackle glaze on a cup",
       .recipes = {"cup"},
       .shape = "shape:cup?n=170",
       .azimuth = 0,
       .elevation = 20,
       .paper_triangles = 39611,
       .paper_time = "43 minutes"},
      {.number = 8,
       .name = "drying",
       .title = "Mud drying, in frames",
       .kind = FigureKind::frames,
       .recipes = {"mud_straight"},
       .shape = mud_plate,
       .elevation = 55},
      {.number = 9,
       .name = "curl",
       .title = "Curled mud",
       .recipes = {"mud_curled"},
       .shape = mud_plate,
       .elevation = 40,
       .paper_triangles = 19602,
       .paper_time = "2.0 minutes"},
      {.number = 10,
       .name = "horse",
       .title = "Separation tensor weighted by κ₁² + κ₂²",
       .recipes = {"horse"},
       .mesh = "horse_30k.obj",
       .shape = "shape:bumps?n=39&radius=0.08",
       .azimuth = 25,
       .paper_triangles = 30008,
       .paper_time = "1.5 hours"},
      {.number = 11,
       .name = "mud-straight",
       .title = "Dried mud, α = 0.85",
       .recipes = {"mud_straight"},
       .shape = mud_plate,
       .elevation = 55,
       .paper_triangles = 19602,
       .paper_time = "2.7 minutes"},
      {.number = 12,
       .name = "mud-jagged",
       .title = "Dried mud, α = 0.5",
       .recipes = {"mud_jagged", "mud_by_force"},
       .shape = mud_plate,
       .elevation = 55,
       .paper_triangles = 19602,
       .paper_time = "2.0 minutes"},
  };
  return table;
}

const Figure& find_figure(const std::string& name_or_number) {
  std::vector<std::string> names;
  for (const Figure& figure : figure_table()) {
    if (name_or_number == figure.name || name_or_number == std::to_string(figure.number)) {
      return figure;
    }
    names.emplace_back(figure.name);
  }
  const std::string nearest = nearest_name(name_or_number, names);
  throw Error(
      ErrorKind::usage, "unknown figure", name_or_number,
      nearest.empty() ? "craze figures --help lists them" : "did you mean " + nearest + "?");
}

const Preset& find_figure_recipe(std::string_view name) {
  const auto& all = figure_recipes();
  return *std::find_if(all.begin(), all.end(), [&](const Preset& p) { return p.name == name; });
}

}  // namespace craze
