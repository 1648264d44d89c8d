// The pictures of a material with the cracks in them.
#pragma once

#include <optional>
#include <vector>

#include "craze/base/surface_pictures.h"
#include "craze/context.h"
#include "craze/engine/width_by_age.h"
#include "craze/maps.h"

namespace craze {

/// How cracks change the base colour.
struct CrackStain {
  /// Linear; none: the surface's own colour, darkened.
  std::optional<Color> color;
  /// What is left of the light in a crack that is darkened: that of side walls, which are a quarter
  /// as bright.
  static constexpr double darkened = 0.25;
  /// Of the stain of the first crack, what is left at the last (post.late_width).
  double late = 1;
};

/// Composes one material's pictures with the maps of its cracks as they are baked: in a crack the
/// base colour is stained, roughness goes to 1 and metal to 0 by the share of the texel that it
/// has; occlusions are multiplied; the slopes of both normals add up, as heights would. A picture
/// of another size is sampled bilinearly, repeating.
class CrackPictures : public MapSink {
 public:
  /// The maps that this needs.
  static const std::vector<MapKind>& maps();

  /// `own` must outlive this. base_factor: the factor that the base colour is shown with; a stain
  /// is divided by it.
  CrackPictures(const SurfacePictures& own, const Color& base_factor, const CrackStain& stain,
                const Context& context)
      : own_(own), base_factor_(base_factor), stain_(stain), context_(context) {}

  void begin(const std::vector<MapHeader>& headers) override;
  void rows(int first, int count, const std::vector<const float*>& maps) override;
  void end() override {}

  /// 8 bits, all of them there: base colour with alpha where it had one; occlusion, roughness and
  /// metal in the three channels of one picture, which is both `occlusion` and `roughness`. All
  /// factors are 1.
  SurfacePictures take() { return std::move(cracked_); }

 private:
  void compose(int y, const float* mask, const float* normal, const float* light,
               const float* time);

  const SurfacePictures& own_;
  Color base_factor_;
  const CrackStain& stain_;
  const Context& context_;
  int size_ = 0;
  WidthByAge tone_{1};
  SurfacePictures cracked_;
};

}  // namespace craze
