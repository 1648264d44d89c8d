// What a ray sees where it meets the object.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/material/material.h"
#include "craze/render/material/crack_lines.h"
#include "craze/render/material/look.h"
#include "craze/render/material/marks.h"
#include "craze/render/rays/ray_scene.h"
#include "craze/surface_mesh.h"

namespace craze::render {

/// What is drawn, in render units: near the origin and of unit size.
struct TracedModel {
  std::vector<Vec3> positions;
  std::vector<Vec3> places;  ///< #V: where on the body a vertex is, for patterns that go with it
  std::vector<Triangle> triangles;
  std::vector<Vec3f> normals;         ///< 3 #F
  std::vector<std::uint8_t> is_wall;  ///< #F
  std::vector<std::int32_t> pieces;   ///< #F, the fragment of each face; or empty
  std::vector<Look> looks;            ///< the model's own colours; empty: the material's
  std::vector<std::int32_t> look;     ///< #F, index into looks, −1: none; empty: all of looks[0]
  std::vector<Eigen::Vector2f> uvs;   ///< 3 #F; empty: none, and their textures do not count
  std::vector<std::vector<Eigen::Vector2f>> further_uvs;  ///< of sets 1, 2 …, the same
  const LinePainter* lines = nullptr;
  std::vector<Mark> marks;

  /// Null: the material's own.
  const Look* look_of(std::int32_t face) const;
  /// Empty: there is no such set.
  const std::vector<Eigen::Vector2f>& uvs_of(const PlacedTexture& texture) const;
};

/// A lit point of the object or the floor.
struct Surface {
  bool lit = false, is_floor = false;
  Vec3f position = Vec3f::Zero(), geometric = Vec3f::UnitZ(), normal = Vec3f::UnitZ();
  Vec3f place = Vec3f::Zero();  ///< for patterns
  /// Where rays start: on the smooth surface that the normals belong to, not below it, or triangles
  /// would shade each other in a pattern along the edge of the light.
  Vec3f raised = Vec3f::Zero();
  Vec3f view = Vec3f::UnitZ();  ///< unit, from the eye
  /// All of these but `clear` count only as far as the place is covered.
  Rgb albedo = Rgb::Zero();
  float coat = 0;           ///< part of the light that the coat mirrors
  float cover = 1;          ///< 0 … 1
  Rgb clear = Rgb::Zero();  ///< what is seen of whatever lies behind
};

/// Small irregularities of a material at a place.
struct Grain {
  Rgb tint = Rgb::Ones();      ///< factor of the colour
  Vec3f tilt = Vec3f::Zero();  ///< added to the normal
};

/// Part of the light that a clear, smooth surface mirrors at that cosine to its normal.
float fresnel(float cosine);

/// The body itself at a hit, without its cracks.
LookSample body_at(const TracedModel& model, const Material& material, const Hit& hit);

/// The surface at a hit, its normals towards the eye, with crack lines drawn.
Surface surface_at(const TracedModel& model, const Material& material, const Ray& ray,
                   const Hit& hit, float footprint);

/// `piece` tells fragments apart; walls are rougher. `footprint` is the size of a pixel there.
Grain grain_at(const Material& material, const Vec3f& place, std::int32_t piece, bool wall,
               float footprint);

/// Cracks as the lines drawn at a hit; none on walls.
LineSample line_at(const TracedModel& model, const Hit& hit, const Vec3f& place, float footprint);

}  // namespace craze::render
