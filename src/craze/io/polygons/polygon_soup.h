// What indexed formats hold: polygons whose corners point into lists of positions, UVs and normals.
#pragma once

#include <string>

#include "craze/io/mesh_source.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Indices into the soup's lists; −1: not given. A vertex index is always given. A UV or normal
/// that is out of range was promised and never given.
struct SoupCorner {
  std::int32_t vertex = -1, uv = -1, normal = -1;
};

/// A file's content before its polygons become triangles. Indices may still be out of range.
struct PolygonSoup {
  std::vector<Vec3> positions;
  std::vector<Vec2> uvs;
  std::vector<Vec3> normals;  ///< any length
  std::vector<SoupCorner> corners;
  std::vector<std::size_t> ends;        ///< per polygon: one past its last corner
  std::vector<std::size_t> lines;       ///< per polygon: its line in the file, or empty
  std::vector<std::int32_t> materials;  ///< per polygon, or empty
  std::vector<std::int32_t> objects;    ///< per polygon, or empty

  /// Ends the polygon whose corners were appended last.
  void close_polygon() { ends.push_back(corners.size()); }
};

/// Checks every index, cuts the polygons into triangles and fills positions, triangles,
/// source_faces, corner_uvs, corner_normals, face_materials and face_objects. Polygons of fewer
/// than three corners vanish, with a warning. A corner without a UV gets (0, 0), one without a
/// normal its triangle's; warns where they were never given. Throws Error(input) for a vertex out
/// of range and where no triangle is left.
SurfaceMesh triangulate(PolygonSoup&& soup, const MeshSource& source);

/// Throws Error(input) for a mesh that has no triangle, or more vertices or corners than 2³¹ − 1.
void check_size(const SurfaceMesh& mesh, const std::string& name);

/// Makes every normal unit; those without a direction become their triangle's normal, or +z where
/// that has none.
void normalize_corner_normals(SurfaceMesh& mesh);
/// The same of normals, 3 #F, that the mesh does not hold itself.
void normalize_corner_normals(const SurfaceMesh& mesh, std::vector<Vec3>& normals);

}  // namespace craze
