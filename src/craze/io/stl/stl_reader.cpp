// Format: 3D Systems, "StereoLithography Interface Specification", 1988.

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>
#include <numeric>
#include <tuple>

#include "craze/base/random.h"
#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/polygons/polygon_soup.h"
#include "craze/io/stl/stl.h"
#include "craze/io/stl/stl_facets.h"

namespace craze {

namespace {

std::size_t hash_place(const Vec3& p) {
  std::uint64_t hash = 0;
  for (const double x : p) {
    const double unsigned_zero = x + 0.0;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &unsigned_zero, sizeof bits);
    hash = hash_bits(hash ^ bits);
  }
  return hash;
}

/// The corners in an order that puts those at the same place together, rising among themselves:
/// scattered into buckets by hash, then sorted within each. No choice of places makes it slow.
std::vector<std::int32_t> gather_places(const std::vector<Vec3>& corners) {
  const std::size_t buckets = std::bit_ceil(corners.size() + 1);
  std::vector<std::size_t> begin(buckets + 1, 0);
  std::vector<std::uint32_t> bucket;
  bucket.reserve(corners.size());
  for (const Vec3& p : corners) {
    bucket.push_back(static_cast<std::uint32_t>(hash_place(p) & (buckets - 1)));
    ++begin[bucket.back() + 1];
  }
  for (std::size_t b = 0; b < buckets; ++b) begin[b + 1] += begin[b];
  std::vector<std::int32_t> order(corners.size());
  std::vector<std::size_t> at = begin;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    order[at[bucket[c]]++] = static_cast<std::int32_t>(c);
  }
  const auto less = [&](std::int32_t a, std::int32_t b) {
    const Vec3 &p = corners[a], &q = corners[b];
    return std::tie(p.x(), p.y(), p.z(), a) < std::tie(q.x(), q.y(), q.z(), b);
  };
  for (std::size_t b = 0; b < buckets; ++b) {
    std::sort(order.data() + begin[b], order.data() + begin[b + 1], less);
  }
  return order;
}

/// Makes one vertex of corners at the same place.
void weld(const std::vector<Vec3>& corners, SurfaceMesh& mesh) {
  const std::vector<std::int32_t> order = gather_places(corners);
  // Each corner's leader is the first one at its place.
  std::vector<std::int32_t> leader(corners.size()), vertex(corners.size());
  std::int32_t first = order.empty() ? 0 : order[0];
  for (const std::int32_t c : order) {
    if (corners[c] != corners[first]) first = c;
    leader[c] = first;
  }
  mesh.triangles.resize(corners.size() / 3);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (leader[c] == static_cast<std::int32_t>(c)) {
      vertex[c] = static_cast<std::int32_t>(mesh.positions.size());
      mesh.positions.push_back(corners[c]);
    }
    mesh.triangles[c / 3][c % 3] = vertex[leader[c]];
  }
}

/// What a file says besides its triangles.
class StlScene : public SourceScene {
 public:
  StlScene(std::vector<std::string> solids, const std::string& title) {
    if (!solids.empty()) contents_.push_back({"names of solids", std::move(solids), true});
    if (!title.empty()) contents_.push_back({"the header's text", {title}, true});
  }
  std::vector<SceneContent> contents() const override { return contents_; }

 private:
  std::vector<SceneContent> contents_;
};

}  // namespace

SurfaceMesh read_stl(const MeshSource& source) {
  StlFacets facets = read_stl_facets(source);
  if (facets.corners.size() > 2147483647) {
    fail_input(source.name, "it has more than 2^31 - 1 corners");
  }
  SurfaceMesh mesh;
  weld(facets.corners, mesh);
  mesh.source_faces.resize(mesh.triangles.size());
  std::iota(mesh.source_faces.begin(), mesh.source_faces.end(), 0);
  mesh.face_attributes = std::move(facets.colors);
  check_size(mesh, source.name);
  if (!facets.solids.empty() || !facets.title.empty()) {
    source.scene = std::make_shared<const StlScene>(std::move(facets.solids), facets.title);
  }
  return mesh;
}

}  // namespace craze
