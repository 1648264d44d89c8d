// A surface as files hold it: triangles with everything attached, no adjacency.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "craze/tensor.h"

namespace craze {

using Triangle = std::array<std::int32_t, 3>;
using Color = std::array<float, 4>;  ///< linear red, green, blue, alpha in 0 … 1

/// A named quantity per vertex or per face. values has `components` numbers per element.
struct Attribute {
  std::string name;
  int components = 1;
  std::vector<double> values;
};

/// Triangles with attributes. Every array but positions and triangles may be empty: "not given".
struct SurfaceMesh {
  std::vector<Vec3> positions;               ///< #V, model units
  std::vector<Triangle> triangles;           ///< #F, vertex indices, counter-clockwise from outside
  std::vector<Vec2> corner_uvs;              ///< 3 #F: corner i of triangle f at 3f+i; seams differ
  std::vector<Vec3> corner_normals;          ///< 3 #F, unit
  std::vector<Color> vertex_colors;          ///< #V
  std::vector<std::int32_t> face_materials;  ///< #F, index into material_names, −1: none
  std::vector<std::string> material_names;
  std::vector<std::int32_t> face_objects;    ///< #F, index into object_names, −1: none
  std::vector<std::string> object_names;     ///< of glTF nodes that show meshes; OBJ's `o`, `g`
  std::vector<Attribute> vertex_attributes;  ///< any named scalar or vector of the file
  std::vector<Attribute> face_attributes;
  double metres_per_unit = 0;              ///< of the positions; 0: the file does not say
  std::vector<std::int32_t> source_faces;  ///< #F: the file's polygon each triangle came from
};

/// The attribute of that name, or nullptr.
const Attribute* find_attribute(const std::vector<Attribute>& attributes, const std::string& name);

/// The attribute of the elements `from`, in that order; an element may come more than once.
Attribute pick(const Attribute& source, const std::vector<std::int32_t>& from);

}  // namespace craze
