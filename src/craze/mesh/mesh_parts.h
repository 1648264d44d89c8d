// A mesh as several objects, for formats that know objects.
#pragma once

#include <string>
#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

struct MeshPart {
  std::string name;
  std::vector<std::int32_t> faces;  ///< of the whole mesh, ascending
};

/// The face attribute that tells parts apart. Throws Error(request) where there is no such number.
const Attribute& part_numbers(const SurfaceMesh& mesh, const std::string& attribute);

/// One part per value of the face attribute, which must be there: "fragment_3" holds the faces
/// whose `fragment` is 3. Parts are in the order of their values.
std::vector<MeshPart> mesh_parts(const SurfaceMesh& mesh, const std::string& attribute);

/// A part by itself: its faces and their vertices, in the order of the whole mesh.
struct ExtractedPart {
  SurfaceMesh mesh;
  std::vector<std::int32_t> vertices;  ///< #V of the part: the vertex of the whole mesh
};
ExtractedPart extract_part(const SurfaceMesh& mesh, const std::vector<std::int32_t>& faces);

}  // namespace craze
