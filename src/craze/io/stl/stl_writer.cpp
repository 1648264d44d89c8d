#include <algorithm>
#include <cmath>

#include "craze/base/progress_meter.h"
#include "craze/base/text/format.h"
#include "craze/io/bytes/byte_order.h"
#include "craze/io/polygons/face_normal.h"
#include "craze/io/polygons/single_precision.h"
#include "craze/io/stl/stl.h"
#include "craze/io/stl/stl_facets.h"

namespace craze {

namespace {

/// The colours of faces, red, green and blue in 0 … 255, as VisCAM and SolidView have them: five
/// bits each.
class WrittenColors {
 public:
  explicit WrittenColors(const SurfaceMesh& mesh) {
    const char* names[] = {"red", "green", "blue"};
    for (int c = 0; c < 3; ++c) {
      const Attribute* a = find_attribute(mesh.face_attributes, names[c]);
      if (!a || a->components != 1) return;
      channel_[c] = &a->values;
    }
    is_given_ = true;
  }

  std::uint16_t of(std::size_t face) const {
    if (!is_given_) return 0;
    unsigned color = 1u << 15;
    for (int c = 0; c < 3; ++c) {
      const double x = (*channel_[c])[face], kept = x > 0 ? std::min(x, 255.0) : 0;  // NaN: none
      color |= static_cast<unsigned>(std::lround(kept * 31 / 255)) << (10 - 5 * c);
    }
    return static_cast<std::uint16_t>(color);
  }

 private:
  const std::vector<double>* channel_[3] = {};
  bool is_given_ = false;
};

}  // namespace

void write_stl(const SurfaceMesh& mesh, const MeshFileOptions& options, ByteSink& sink,
               const Context& context) {
  ProgressMeter meter(context, "write", mesh.triangles.size());
  std::string& bytes = sink.pending();
  bytes.assign(80, '\0');
  bytes.replace(0, own_title.size(), own_title);
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  const WrittenColors colors(mesh);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    meter.at(f);
    for (const float x : to_floats(face_normal(mesh, f), "STL")) append(bytes, x);
    for (const std::int32_t v : mesh.triangles[f]) {
      for (const float x : to_floats(mesh.positions[v], "STL")) append(bytes, x);
    }
    append(bytes, colors.of(f));
    sink.pass_on();
  }
  if (options.warn) {
    if (const std::string loss = describe_precision_loss(mesh); !loss.empty()) {
      options.warn("STL holds single precision alone: " + loss);
    }
  }
}

}  // namespace craze
