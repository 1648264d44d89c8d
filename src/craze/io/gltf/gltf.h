// glTF 2.0, as JSON or as GLB.
#pragma once

#include <string>
#include <string_view>

#include "craze/io/bytes/byte_sink.h"
#include "craze/io/mesh_source.h"
#include "craze/surface_mesh.h"
#include "craze/write_mesh.h"

namespace craze {

/// Reads all triangles of the default scene (of every root node where the file has no scene),
/// placed as the file stands: by its nodes' transforms, or by joints where the mesh has a skin;
/// morph targets with the weights of the node or else of the mesh; EXT_mesh_gpu_instancing
/// followed. Lists, strips and fans; POSITION, NORMAL, TEXCOORD_0 (v turned to count upwards),
/// COLOR_0 and custom `_NAME` attributes (as "name"); material names; the
/// names of the nodes as objects ("node_N" for one without). Vertices are as the file has
/// them, so seams stay open. Buffers may be data URIs, GLB's chunk, or files that the source
/// brings. Warns of what is left out. Data compressed with Draco or meshopt are refused, and so are
/// files that require an extension that is not known here. Instances may expand a file to at most 4
/// million elements more than twice its bytes. Throws Error(input).
SurfaceMesh read_gltf(const MeshSource& source);

/// Whether the bytes begin with the magic number of GLB, or with an object of JSON.
bool is_glb(std::string_view bytes);
bool is_gltf(std::string_view bytes);

/// Whether write_glb() writes the input's scene again, with all that it had: it is of a glTF file,
/// and the mesh is cut out of its own triangles.
bool keeps_scene(const MeshFileOptions& options);
/// Whether it writes the scene's nodes again, showing the mesh: it is of a glTF file, faces know
/// their objects, and nothing moves.
bool keeps_nodes(const SurfaceMesh& mesh, const MeshFileOptions& options);

/// The mesh as GLB: single precision, axes as they are, one primitive per material (a plain matt
/// one where the mesh names none, dark for "crack_wall"), vertices copied at seams. UVs are
/// flipped, since glTF counts v downwards. Vertex attributes become `_NAME`, one float accessor
/// each up to four components and one per component above. Parts of a mesh that met still meet, to
/// the last bit. A mesh so far from the origin that single precision would move it by 10⁻⁶ of its
/// size is written about its middle, under a node that puts it in its place. Throws Error(request)
/// for coordinates beyond single precision and for more than 4 GB.
void write_glb(const SurfaceMesh& mesh, const MeshFileOptions& options, ByteSink& sink,
               const Context& context);

}  // namespace craze
