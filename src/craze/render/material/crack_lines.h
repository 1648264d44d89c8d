// The paper's dark crack lines, drawn from the distance to the nearest crack at every point.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "craze/context.h"
#include "craze/products/distance/nearby_cracks.h"
#include "craze/render/material/color.h"

namespace craze::render {

/// What is to be drawn on the mesh's own faces.
struct CrackLines {
  NearbyCracks cracks;  ///< per face of the mesh that is drawn
  /// One per segment: the width at its two ends in units of the line width; empty: 1 everywhere.
  std::vector<std::array<float, 2>> width;
  /// #V of the mesh the lines were measured on, where the one that is drawn has moved since; empty:
  /// it has not.
  std::vector<Vec3> places;
  bool open = false;  ///< the cracks are gaps: there is no line, but edges that are worn
};

/// The lines of a cut mesh along `sides`, all of width 1.
CrackLines crack_lines(const TriangleMesh& mesh, const std::vector<std::int32_t>& sides,
                       double reach, const Context& context);

/// Gives each line the width of its ends, in units of the line width: `width` has two numbers for
/// each of `sides`, the halfedges that the lines were made of, ascending.
void set_widths(CrackLines& lines, const std::vector<std::int32_t>& sides,
                const std::vector<std::array<float, 2>>& width);

/// How a crack looks at a point.
struct LineSample {
  float core = 0;              ///< 0 … 1, coverage by the line itself
  float stain = 0;             ///< 0 … 1, fading out beside it
  Vec3f tilt = Vec3f::Zero();  ///< how far the groove's side leans, 0 … 1, towards the crack
  Vec3f away = Vec3f::Zero();  ///< from the nearest point of a crack to here; zero: none is near
};

/// Crack lines in the renderer's units.
class LinePainter {
 public:
  /// `half_width` of a line of width 1, in render units; points are scale (p − origin).
  LinePainter(const CrackLines& lines, const Vec3& origin, double scale, double half_width);

  /// At a point of face f. Lines finer than about the footprint (the size of a pixel there) are
  /// drawn wider and paler, so that they never alias.
  LineSample at(std::int32_t f, const Vec3f& point, float footprint) const;

  bool shows_gaps() const { return open_; }

  /// The distance, in line widths, beyond which a line leaves no trace.
  static constexpr double reach = 6;

 private:
  struct Segment {
    Vec3f a, along;
    float inverse_squared_length, half_width_a, half_width_b;
  };
  std::vector<std::int32_t> first_;
  std::vector<Segment> segments_;
  bool open_;
};

}  // namespace craze::render
