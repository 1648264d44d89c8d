#include "craze/io/polygons/polygon_soup.h"

#include <algorithm>
#include <limits>
#include <span>

#include "craze/base/progress_meter.h"
#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/polygons/face_normal.h"
#include "craze/io/polygons/polygon.h"

namespace craze {

namespace {

constexpr std::size_t max_index = std::numeric_limits<std::int32_t>::max();

bool in_range(std::int32_t index, std::size_t count) {
  return index >= 0 && static_cast<std::size_t>(index) < count;
}

/// Turns one polygon after another into triangles of the mesh.
class Triangulator {
 public:
  Triangulator(const PolygonSoup& soup, const std::string& name) : soup_(soup), name_(name) {
    for (const SoupCorner& c : soup.corners) {
      has_uvs_ = has_uvs_ || in_range(c.uv, soup.uvs.size());
      has_normals_ = has_normals_ || in_range(c.normal, soup.normals.size());
    }
    const std::size_t fewest = soup.corners.size() / 3;
    mesh.triangles.reserve(fewest);
    mesh.source_faces.reserve(fewest);
    if (has_uvs_) mesh.corner_uvs.reserve(3 * fewest);
    if (has_normals_) mesh.corner_normals.reserve(3 * fewest);
  }

  void add(std::size_t polygon) {
    const std::size_t begin = polygon == 0 ? 0 : soup_.ends[polygon - 1];
    const std::span corners(soup_.corners.data() + begin, soup_.ends[polygon] - begin);
    for (const SoupCorner& c : corners) check(c, polygon);
    triples_.clear();
    if (corners.size() == 3) {
      triples_.push_back({0, 1, 2});
    } else if (corners.size() > 3) {
      outline_.clear();
      for (const SoupCorner& c : corners) outline_.push_back(soup_.positions[c.vertex]);
      if (!triangulate_polygon(outline_, triples_)) {
        fail_input(
            where(polygon),
            fmt::format(
                "a face that is not convex has {} corners, more than {}; triangulate it before",
                corners.size(), max_concave_corners));
      }
    }
    for (const CornerTriple& t : triples_) {
      mesh.triangles.push_back({corners[t[0]].vertex, corners[t[1]].vertex, corners[t[2]].vertex});
      mesh.source_faces.push_back(static_cast<std::int32_t>(polygon));
      if (!soup_.materials.empty()) mesh.face_materials.push_back(soup_.materials[polygon]);
      if (!soup_.objects.empty()) mesh.face_objects.push_back(soup_.objects[polygon]);
      for (const std::int32_t i : t) add_corner(corners[i]);
    }
  }

  SurfaceMesh mesh;

 private:
  std::string where(std::size_t polygon) const {
    return soup_.lines.empty() ? name_ + ", face " + std::to_string(polygon)
                               : at_line(name_, soup_.lines[polygon]);
  }

  void check(const SoupCorner& c, std::size_t polygon) const {
    if (in_range(c.vertex, soup_.positions.size())) return;
    // Lines belong to OBJ, which counts from 1.
    if (c.vertex < 0) {
      fail_input(where(polygon),
                 fmt::format("a corner's index is none of 0 to {}", soup_.positions.size() - 1));
    }
    const std::int64_t shown = soup_.lines.empty() ? c.vertex : std::int64_t{c.vertex} + 1;
    fail_input(where(polygon),
               fmt::format("a corner asks for vertex {} of {}", shown, soup_.positions.size()));
  }

  void add_corner(const SoupCorner& c) {
    if (has_uvs_) {
      const bool given = in_range(c.uv, soup_.uvs.size());
      mesh.corner_uvs.push_back(given ? soup_.uvs[c.uv] : Vec2(0, 0));
    }
    if (has_normals_) {
      const bool given = in_range(c.normal, soup_.normals.size());
      mesh.corner_normals.push_back(given ? soup_.normals[c.normal] : Vec3(0, 0, 0));
    }
  }

  const PolygonSoup& soup_;
  const std::string& name_;
  bool has_uvs_ = false, has_normals_ = false;
  std::vector<CornerTriple> triples_;
  std::vector<Vec3> outline_;
};

/// Of indices that name something, those that name nothing there is.
void warn_of_missing(const MeshSource& source, const PolygonSoup& soup, const char* what,
                     std::int32_t SoupCorner::*index, std::size_t count) {
  const auto missing = std::count_if(
      soup.corners.begin(), soup.corners.end(),
      [&](const SoupCorner& c) { return c.*index != -1 && !in_range(c.*index, count); });
  if (missing == 0) return;
  source.warn(fmt::format("{} corners name {} that the file never gives; they are left without",
                          missing, what));
}

void warn_of_short_faces(const MeshSource& source, const PolygonSoup& soup) {
  std::size_t begin = 0, count = 0;
  for (const std::size_t end : soup.ends) {
    count += end - begin < 3;
    begin = end;
  }
  if (count > 0)
    source.warn(fmt::format("{} faces of fewer than three corners are left out", count));
}

}  // namespace

SurfaceMesh triangulate(PolygonSoup&& soup, const MeshSource& source) {
  const std::string& name = source.name;
  if (soup.ends.size() > max_index) fail_input(name, "it has more than 2^31 - 1 faces");
  warn_of_missing(source, soup, "texture coordinates", &SoupCorner::uv, soup.uvs.size());
  warn_of_missing(source, soup, "normals", &SoupCorner::normal, soup.normals.size());
  warn_of_short_faces(source, soup);
  Triangulator triangulator(soup, name);
  ProgressMeter meter(source.context, {}, soup.ends.size());
  for (std::size_t p = 0; p < soup.ends.size(); ++p) {
    meter.at(p);
    triangulator.add(p);
  }
  SurfaceMesh mesh = std::move(triangulator.mesh);
  mesh.positions = std::move(soup.positions);
  check_size(mesh, name);
  normalize_corner_normals(mesh);
  return mesh;
}

void check_size(const SurfaceMesh& mesh, const std::string& name) {
  if (mesh.triangles.empty()) fail_input(name, "it has no triangles");
  if (mesh.positions.size() > max_index) fail_input(name, "it has more than 2^31 - 1 vertices");
  if (mesh.triangles.size() > max_index / 3) fail_input(name, "it has more than 2^31 - 1 corners");
}

void normalize_corner_normals(SurfaceMesh& mesh) {
  normalize_corner_normals(mesh, mesh.corner_normals);
}

void normalize_corner_normals(const SurfaceMesh& mesh, std::vector<Vec3>& normals) {
  for (std::size_t c = 0; c < normals.size(); ++c) {
    Vec3& n = normals[c];
    n = n.stableNormalized();
    if (std::abs(n.squaredNorm() - 1) < 1e-9) continue;
    n = face_normal(mesh, c / 3);
    if (n.isZero()) n = Vec3::UnitZ();
  }
}

}  // namespace craze
