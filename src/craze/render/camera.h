// A perspective camera that frames what it is shown.
#pragma once

#include <optional>

#include "craze/render/subject.h"
#include "craze/tensor.h"
#include "craze/up_axis.h"

namespace craze::render {

using craze::UpAxis;

/// Where the picture is taken from. At azimuth 0 the first horizontal axis (x, or y when x is up)
/// runs to the right; the camera moves to the right as the azimuth grows.
struct View {
  /// Of the world. Automatic turns a sheet that faces down over, so that its front is seen.
  UpAxis up = UpAxis::automatic;
  /// Degrees; by default 0 for flat plates, 25 otherwise, counted from where a sheet that stands
  /// faces, or from the broad side of a slab that stands.
  std::optional<double> azimuth;
  std::optional<double> elevation;  ///< degrees above the horizon; by default 55 and 18
  double field_of_view = 24;        ///< vertical, degrees
  double margin = 0.08;             ///< free border, as a fraction of the picture
  double zoom = 1;                  ///< 2: twice as near as what shows all
  std::optional<Vec3> target;       ///< the point in the middle; by default the object's
  /// Of the lens, its diameter as a part of the object's diagonal; 0: all is sharp.
  double aperture = 0;
  std::optional<Vec3> focus;  ///< the point that is sharp; by default what is seen in the middle
};

struct Camera {
  Vec3 eye;
  Vec3 right, up, forward;  ///< orthonormal
  Vec3 vertical;            ///< unit, the world's up
  double tan_x, tan_y;      ///< half extents of the picture at distance 1
  double elevation;         ///< degrees
  double aperture = 0;      ///< diameter of the lens
  double focus = 0;  ///< distance along `forward` of what is sharp; 0: of what is in the middle

  /// Towards a place on the picture, x to the right and y upwards in −1 … 1; length 1 along
  /// `forward`.
  Vec3 ray(double x, double y) const { return forward + x * tan_x * right + y * tan_y * up; }
};

/// The camera nearest to the subject's points that has them all inside the margin. `aspect` is
/// width over height. There must be at least one point.
Camera frame(const Subject& subject, const View& view, double aspect);

}  // namespace craze::render
