#include "craze/products/maps/bake_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "craze/base/progress_meter.h"
#include "craze/error.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/mesh/uv_islands.h"
#include "craze/model/sources/curvature.h"
#include "craze/products/maps/bake_sheet.h"

namespace craze {

namespace {

bool asks_for(const MapOptions& options, MapKind kind) {
  return std::find(options.maps.begin(), options.maps.end(), kind) != options.maps.end();
}

/// Mean curvature at the vertices.
std::vector<double> mean_curvature(const SurfaceMesh& surface, const Context& context) {
  const TriangleMesh mesh(surface.positions, surface.triangles);
  std::vector<double> mean;
  for (const PrincipalCurvature& k : vertex_curvature(mesh, 0, context)) mean.push_back(k.mean());
  return mean;
}

/// What a mesh from a file does not know.
void warn_of_unknown(const MapSurface& maps, const PostParameters& post,
                     std::vector<std::string>& warnings) {
  if (!maps.has_widths && post.gap > 0) {
    warnings.emplace_back(
        "how far the cracks open is not known (the mesh has no vertex attribute displacement): "
        "post.gap is left out, cracks are hairlines; post.gap_width gives them one width");
  }
  if (!maps.has_times && post.late_width != 1) {
    warnings.emplace_back(
        "when the cracks opened is not known (the mesh has no vertex attribute crack_time): "
        "post.late_width is left out");
  }
}

/// What integers of each map range over.
class Ranges {
 public:
  Ranges(const MapSurface& maps, const GrooveSizes& sizes, const MapLift& lift, double farthest,
         const std::vector<double>& base_curvature)
      : lowest_(lift.lowest()), highest_(lift.highest()) {
    for (const Vec3& p : maps.surface.positions) box_.extend(p);
    farthest_ = std::min(farthest, box_.diagonal().norm());
    double total = 0;
    for (std::size_t i = 0; i < maps.cracks.size(); ++i) {
      const MapCrack& crack = maps.cracks[i];
      for (const double half : sizes.half_width[i]) {
        widest_ = std::max(widest_, 2 * half);
        deepest_ = std::max(deepest_, sizes.depth(half));
        total += half;
      }
      first_ = std::min(i > 0 ? first_ : crack.time, crack.time);
      last_ = std::max(i > 0 ? last_ : crack.time, crack.time);
      cracks_ = std::max(cracks_, crack.number + 1);
    }
    double bites = 0;
    for (const Chip& chip : sizes.chips.chips) {
      deepest_ = std::max(deepest_, chip.depth);
      bites = std::max(bites, chip.inwards);
    }
    widest_ += 2 * bites;
    for (const MapPiece& piece : maps.pieces) fragments_ = std::max(fragments_, piece.fragment + 1);
    // A rim as round as the grooves are wide on average is white; base curvature fits in too.
    if (total > 0) sharpest_ = 2 * static_cast<double>(maps.cracks.size()) / total;
    for (const double k : base_curvature) sharpest_ = std::max(sharpest_, std::abs(k));
  }

  void set(MapHeader& header) const {
    const auto range = [&header](double low, double high) {
      header.low.fill(low);
      header.high.fill(high > low ? high : low + 1);
    };
    switch (header.kind) {
      case MapKind::height:
        return range(lowest_ - deepest_, highest_);
      case MapKind::curvature:
        return range(-sharpest_, sharpest_);
      case MapKind::distance:
        return range(0, farthest_);
      case MapKind::width:
        return range(0, widest_);
      case MapKind::time:
        return range(first_, last_);
      case MapKind::crack:
        return range(0, cracks_);
      case MapKind::fragment:
        return range(0, fragments_);
      case MapKind::position:
        for (int i = 0; i < 3; ++i) {
          header.low[i] = box_.min()[i];
          header.high[i] = box_.max()[i] > box_.min()[i] ? box_.max()[i] : box_.min()[i] + 1;
        }
        return;
      default:
        return range(0, 1);
    }
  }

 private:
  Eigen::AlignedBox3d box_;
  double lowest_, highest_;  // of the surface beside the grooves
  double farthest_ = 0, widest_ = 0, deepest_ = 0, first_ = 0, last_ = 0, sharpest_ = 0;
  std::int32_t cracks_ = 0, fragments_ = 0;
};

}  // namespace

void check_map_options(const MapOptions& options) {
  const auto wrong = [](const char* what, const std::string& where, const char* why) {
    throw Error(ErrorKind::usage, what, where, why);
  };
  if (options.size < 1 || options.size > MapOptions::largest_size) {
    wrong("wrong size of maps", std::to_string(options.size), "must be in [1, 8192]");
  }
  std::set<MapKind> seen;
  for (const MapKind kind : options.maps) {
    if (kind > map_table().back().kind) {
      wrong("surfaces have no such map", std::string(map_info(kind).name), "tiles have");
    }
    if (!seen.insert(kind).second) {
      wrong("the same map twice", std::string(map_info(kind).name), "ask for it once");
    }
  }
  const auto is_length = [](double x) { return std::isfinite(x) && x >= 0; };
  if (!is_length(options.post.gap)) wrong("wrong gap", "post.gap", "must be finite, 0 or more");
  if (!(options.post.chipping >= 0 && options.post.chipping <= 1)) {
    wrong("wrong chipping", "post.chipping", "must be in [0, 1]");
  }
  if (!is_length(options.post.chip_size)) {
    wrong("wrong size of chips", "post.chip_size", "must be finite, 0 or more");
  }
  if (!std::isfinite(options.post.curl)) wrong("wrong curl", "post.curl", "must be finite");
  if (!is_length(options.post.wall)) wrong("wrong wall", "post.wall", "must be finite, 0 or more");
}

std::vector<std::string> bake_surface(const MapSurface& maps, MapOptions options, MapSink& sink,
                                      const Context& whole) {
  check_map_options(options);
  if (options.maps.empty()) {
    for (const MapInfo& info : map_table()) options.maps.push_back(info.kind);
  }
  constexpr double preparing = 0.25;  // about, of all time
  const Context context = phase_part(whole, "maps", 0, preparing);
  context.report({"maps", 0});
  UvLayout layout = uv_layout(maps, options.by_material, context);
  warn_of_unknown(maps, options.post, layout.warnings);
  if (maps.cracks.empty()) {
    layout.warnings.emplace_back("there are no cracks that lie shut: the maps show none");
  }
  const MapFaces faces(maps.surface);
  const GrooveSizes sizes = groove_sizes(maps, options.post);
  layout.warnings.insert(layout.warnings.end(), sizes.warnings.begin(), sizes.warnings.end());
  // A tile is flat, and one island without a border, wherever it was cut open.
  const std::size_t count = maps.surface.triangles.size();
  const std::vector<std::int32_t> islands =
      maps.is_tile() ? std::vector<std::int32_t>(count, 0) : uv_islands(maps.surface);
  const std::vector<std::uint8_t> at_border =
      maps.is_tile() ? std::vector<std::uint8_t>(count, 0) : faces_at_uv_border(maps.surface);
  const GrooveSampler grooves(maps, faces, at_border, sizes, options.size, context);
  std::vector<double> curvature;
  if (asks_for(options, MapKind::curvature)) {
    curvature = maps.is_tile() ? std::vector<double>(maps.surface.positions.size(), 0)
                               : mean_curvature(maps.surface, context);
  }
  const MapLift lift(maps, faces, sizes);
  const Ranges ranges(maps, sizes, lift, grooves.farthest(), curvature);
  const BakeScene scene{maps, faces, sizes, grooves, lift, islands, curvature, options};
  const double share = (1 - preparing) / static_cast<double>(layout.sheets.size());
  for (std::size_t i = 0; i < layout.sheets.size(); ++i) {
    std::vector<MapHeader> headers;
    for (const MapKind kind : options.maps) {
      const MapSheet& sheet = layout.sheets[i];
      MapHeader header{kind,       sheet.texture_set, sheet.material,
                       sheet.udim, options.size,      options.green_up};
      ranges.set(header);
      headers.push_back(header);
    }
    const double from = preparing + static_cast<double>(i) * share;
    bake_sheet(scene, layout.sheets[i], headers, sink,
               phase_part(whole, "maps", from, from + share));
  }
  whole.report({"maps", 1});
  return layout.warnings;
}

}  // namespace craze
