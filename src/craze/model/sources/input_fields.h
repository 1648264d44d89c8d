// What the model may look up in the input besides its shape: painted values and pictures.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "craze/grey_image.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/surface_mesh.h"

namespace craze {

/// The simulation mesh's attributes before its first cut: #V and #F are those of the TriangleMesh
/// that is handed over beside it. Any part may be empty: "not given".
struct InputFields {
  std::vector<Attribute> vertex_attributes;
  std::vector<Attribute> face_attributes;
  std::vector<Vec2> corner_uvs;  ///< 3 #F; u right, v up
  GreyImage stress_texture;      ///< stress.texture
  GreyImage material_texture;    ///< material.texture
  GreyImage layer_texture;       ///< layer.texture
  GreyImage onset_texture;       ///< evolution.onset_texture
};

/// The attributes and UVs of a mesh. Vertex colours become the attributes color_r, color_g,
/// color_b, color_a and color, their luminance (linear, as the mesh holds them).
InputFields input_fields(const SurfaceMesh& mesh);

// Below, `key` is the recipe key that asked, for messages: "stress.attribute". A name is looked up
// among the vertex attributes first. Throws Error(request) if there is none of that name, saying
// which there are, or if it has the wrong number of components, is not finite, or is as long as
// another mesh.

/// #F, a scalar attribute; a vertex attribute is averaged over the corners.
std::vector<double> scalar_per_face(const TriangleMesh& mesh, const InputFields& fields,
                                    const std::string& name, const std::string& key);
/// #V, a scalar attribute; a face attribute is averaged over the star, weighted with area.
std::vector<double> scalar_per_vertex(const TriangleMesh& mesh, const InputFields& fields,
                                      const std::string& name, const std::string& key);
/// #F, world axes: a scalar c gives c I; 6 components, or six scalars NAME_xx … NAME_zx (as
/// --fields writes them), give that tensor, in the order xx yy zz xy yz zx.
std::vector<Sym3> tensor_per_face(const TriangleMesh& mesh, const InputFields& fields,
                                  const std::string& name, const std::string& key);

/// #F, 0 … 1: the picture at the mean of each face's corner UVs. Throws Error(request) without UVs.
std::vector<double> texture_per_face(const TriangleMesh& mesh, const InputFields& fields,
                                     const GreyImage& image, const std::string& key);
/// #V: the mean of the picture at the UVs that the vertex has in the corners of its star.
std::vector<double> texture_per_vertex(const TriangleMesh& mesh, const InputFields& fields,
                                       const GreyImage& image, const std::string& key);
/// #F, 1 where a pixel that counts at the middle or a corner of the face is 0.
std::vector<std::uint8_t> black_faces(const TriangleMesh& mesh, const InputFields& fields,
                                      const GreyImage& image, const std::string& key);

}  // namespace craze
