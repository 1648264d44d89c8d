#include "craze/products/maps/tile_look.h"

#include <algorithm>

#include "craze/engine/run_outcome.h"
#include "craze/material/material.h"

namespace craze {

namespace {

/// Cracks of a material where a recipe does not say how wide they are.
struct NaturalGap {
  const char* material;
  double width;  ///< mean, of the spacing; 0: a hairline
  double depth;  ///< of the mean width; 0: each as deep as wide
};

// Looked at, not measured: mud gapes, paint and clay less, glaze and concrete have hairlines.
constexpr NaturalGap natural_gaps[] = {{"mud", 0.09, 1.2}, {"clay", 0.05, 1.2}, {"paint", 0.03, 1}};

constexpr double rough = 0.9, coated = 0.12;  // roughness without a coat and under a full one

Color as_color(const render::Rgb& c) {
  return {c.x(), c.y(), c.z(), 1};
}

}  // namespace

TileMaterial tile_material(const Recipe& recipe) {
  const render::Material& m = render::find_material(recipe.picture.material);
  TileMaterial tile;
  tile.color = as_color(m.color);
  // In a hairline no wall is seen: it has the colour that pictures draw lines in.
  const bool gapes =
      std::any_of(std::begin(natural_gaps), std::end(natural_gaps),
                  [&](const NaturalGap& gap) { return gap.material == recipe.picture.material; });
  tile.wall = as_color(gapes ? m.wall : m.line);
  tile.mottle = m.mottle;
  tile.pieces = m.pieces;
  tile.stain = m.stain;
  tile.late = recipe.post.late_width;
  tile.roughness = rough + m.coat * (coated - rough);
  return tile;
}

PostParameters tile_grooves(const CrackedTile& tile) {
  PostParameters post = tile.recipe.post;
  if (post.gap > 0) return post;
  for (const NaturalGap& gap : natural_gaps) {
    if (gap.material != tile.recipe.picture.material) continue;
    const double width = gap.width * tile.recipe.simulation.layer.spacing;
    post.gap_width = width;
    if (post.wall == 0) post.wall = gap.depth * width;
    resolve_gap(post, tile.network);
  }
  return post;
}

}  // namespace craze
