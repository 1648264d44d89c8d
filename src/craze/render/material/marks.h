// What a surface bears besides cracks: stains, shadows, joints, scratches, seams.
#pragma once

#include <vector>

#include "craze/render/material/color.h"
#include "craze/tensor.h"

namespace craze::render {

enum class MarkShape {
  line,  ///< along a straight or bent line of some width
  blob,  ///< around a point, with an uneven edge
  half,  ///< on one side of a line: a shadow that falls on the surface
};

/// A mark at a place of the surface, in the units of what it is drawn on.
struct Mark {
  MarkShape shape = MarkShape::line;
  Vec3 point = Vec3::Zero();    ///< a point of the surface
  Vec3 along = Vec3::UnitX();   ///< unit, in the surface there
  Vec3 normal = Vec3::UnitZ();  ///< unit, of the surface there
  double half_width = 0;        ///< line: half its width; blob: its radius; length
  /// Line: from the point to either end; blob: its radius along `along`, 0: round; length.
  double half_length = 0;
  double bend = 0;      ///< line: how far it leaves the straight one over the squared way, 1/length
  double twist = 0;     ///< line: the same over the cubed way, 1/length²
  double taper = 0;     ///< line: 0 … 1, how much narrower it is at its ends
  double softness = 0;  ///< over which it fades at its edge, length
  double unevenness = 0;    ///< of its edge, length
  double depth = 0;         ///< how far it reaches below and above the point's plane, length
  Rgb color = Rgb::Zero();  ///< what is seen of it
  float strength = 1;       ///< 0 … 1, how much of that, or how dark the shadow is
  bool shadow = false;      ///< it dims the light instead of covering the surface
  /// Line: how deep it looks engraved, 0 … 1; below 0, to −1: how far it stands out. Blob likewise,
  /// from its middle.
  float groove = 0;
};

/// The marks in other units: scale (p − origin).
std::vector<Mark> scaled(std::vector<Mark> marks, const Vec3& origin, double scale);

/// What the marks do to a place.
struct MarkSample {
  Rgb color = Rgb::Zero();     ///< of what covers it
  float cover = 0;             ///< 0 … 1
  float light = 1;             ///< factor: 0 … 1
  Vec3f tilt = Vec3f::Zero();  ///< added to the normal
};

/// `footprint` is the size of a pixel there: finer edges are as soft as that.
MarkSample marks_at(const std::vector<Mark>& marks, const Vec3f& place, float footprint);

}  // namespace craze::render
