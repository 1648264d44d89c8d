#include "craze/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "craze/error.h"
#include "craze/mesh/shapes/flat_shapes.h"
#include "craze/mesh/shapes/organic_shapes.h"
#include "craze/mesh/shapes/round_shapes.h"
#include "craze/mesh/shapes/shape_spec.h"

namespace craze {

namespace {

constexpr double tiny = 1e-6, huge = 1e6;

ShapeParameter length(std::string_view name, double standard, std::string_view text) {
  return {name, standard, tiny, huge, false, text};
}
ShapeParameter count(double standard, double low, double high, std::string_view text) {
  return {"n", standard, low, high, true, text};
}

const ShapeParameter edge{"edge", 0, 0, huge, false, "edge length, instead of n; 0: from n"};
const ShapeParameter jitter{
    "jitter", 0, 0, 0.45, false, "displacement of the vertices, as a fraction of a cell"};
const ShapeParameter seed{"seed", 1, 0, 1e9, true, "of the jitter"};

// The edge length asked for, or that of n edges along `circumference`.
double edge_length(const ShapeSpec& spec, double circumference) {
  const double asked = spec["edge"];
  if (asked == 0) return circumference / spec["n"];
  // At most what the largest n gives; one edge in a hundred circumferences would be no surface.
  const double shortest = circumference / 4000;
  if (asked >= shortest && asked <= circumference / 6) return asked;
  throw Error(ErrorKind::usage, "bad value for 'edge'", "shape:" + std::string(spec.shape->name),
              "it must lie between 1/4000 and 1/6 of the largest circumference, here " +
                  std::to_string(shortest) + " and " + std::to_string(circumference / 6));
}

void require(bool holds, const ShapeSpec& spec, const std::string& why) {
  if (holds) return;
  throw Error(ErrorKind::usage, "impossible shape", "shape:" + std::string(spec.shape->name), why);
}

}  // namespace

const std::vector<ShapeInfo>& shape_table() {
  static const std::vector<ShapeInfo> table{
      {"plate",
       "a square of 2 n² triangles, facing +z",
       {count(50, 1, 4000, "cells per side"), length("size", 1, "side length"), jitter, seed}},
      {"strip",
       "a rectangle along x, facing +z",
       {count(10, 1, 2000, "cells across"), length("length", 8, "side along x"),
        length("width", 1, "side along y"), jitter, seed}},
      {"disc",
       "a flat disc facing +z",
       {count(120, 6, 4000, "edges around"), edge, length("radius", 1, "")}},
      {"cube",
       "a closed cube of 12 n² triangles",
       {count(16, 1, 1000, "cells per side"), length("size", 1, "side length")}},
      {"sphere",
       "a geodesic sphere of 20 n² triangles",
       {count(24, 1, 1000, "edges along a side of the icosahedron"), length("radius", 1, "")}},
      {"cylinder",
       "a cylinder along z",
       {count(96, 6, 4000, "edges around"),
        edge,
        length("radius", 1, ""),
        length("height", 2, ""),
        {"open", 0, 0, 1, true, "1: without its flat ends"}}},
      {"torus",
       "a ring about z",
       {count(120, 6, 4000, "edges around the middle of the tube"), edge,
        length("major", 1, "radius of the ring"), length("minor", 0.4, "radius of the tube")}},
      {"bowl",
       "a half sphere with a wall and a rounded lip, standing on z = 0",
       {count(160, 6, 4000, "edges around the lip"), edge, length("radius", 1, ""),
        length("wall", 0.08, "thickness")}},
      {"cup",
       "a tea cup with foot ring and rounded lip, standing on z = 0",
       {count(160, 24, 4000, "edges around the lip"), edge,
        length("radius", 0.4, "at the lip, outside"), length("height", 0.8, ""),
        length("wall", 0.04, "thickness")}},
      {"bumps",
       "a ball with rounded bumps, of 20 n² triangles",
       {count(24, 1, 1000, "edges along a side of the icosahedron"), length("radius", 1, "")}},
      {"drape",
       "a hanging cloth whose folds deepen downwards, standing on z = 0",
       {count(160, 24, 4000, "edges around the base"), edge,
        length("radius", 0.5, "at the base, of the folds' mean"), length("height", 1.6, "")}},
  };
  return table;
}

SurfaceMesh make_shape(std::string_view specification, const Context& context) {
  const ShapeSpec s = parse_shape(specification);
  const std::string_view name = s.shape->name;
  const auto around = [](double radius) { return 2 * std::numbers::pi * radius; };
  if (name == "plate") {
    const int n = s.integer("n");
    return make_rectangle(
        {n, n, s["size"], s["size"], s["jitter"], static_cast<std::uint64_t>(s["seed"])}, context);
  }
  if (name == "strip") {
    const int across = s.integer("n");
    const double along = std::max(1.0, std::round(across * s["length"] / s["width"]));
    require(along * across <= 16e6, s, "more than 32 million triangles: make n or length smaller");
    return make_rectangle({static_cast<int>(along), across, s["length"], s["width"], s["jitter"],
                           static_cast<std::uint64_t>(s["seed"])},
                          context);
  }
  if (name == "disc") return make_disc(s["radius"], edge_length(s, around(s["radius"])), context);
  if (name == "cube") return make_cube(s.integer("n"), s["size"], context);
  if (name == "sphere") return make_sphere(s["radius"], s.integer("n"), context);
  if (name == "cylinder") {
    require(s["height"] <= 100 * s["radius"], s, "height must be at most 100 radii");
    return make_cylinder(s["radius"], s["height"], s["open"] == 1,
                         edge_length(s, around(s["radius"])), context);
  }
  if (name == "torus") {
    require(s["minor"] < s["major"], s, "minor must be smaller than major");
    return make_torus(s["major"], s["minor"], edge_length(s, around(s["major"])), context);
  }
  if (name == "bowl") {
    require(s["wall"] < s["radius"], s, "wall must be smaller than radius");
    return make_bowl(s["radius"], s["wall"], edge_length(s, around(s["radius"])), context);
  }
  if (name == "bumps") return make_bumps(s["radius"], s.integer("n"), context);
  if (name == "drape") {
    require(s["height"] >= s["radius"] && s["height"] <= 20 * s["radius"], s,
            "height must be 1 to 20 radii");
    return make_drape(s["radius"], s["height"], edge_length(s, around(s["radius"])), context);
  }
  require(s["wall"] < 0.3 * s["radius"] && s["wall"] < 0.3 * s["height"], s,
          "wall must be smaller than 0.3 radius and 0.3 height");
  require(s["height"] <= 20 * s["radius"], s, "height must be at most 20 radii");
  return make_cup(s["radius"], s["height"], s["wall"], edge_length(s, around(s["radius"])),
                  context);
}

}  // namespace craze
