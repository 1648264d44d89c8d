// A mesh to bytes, or to a file, of any format the project writes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "craze/collider.h"
#include "craze/context.h"
#include "craze/material_look.h"
#include "craze/surface_mesh.h"
#include "craze/up_axis.h"

namespace craze {

class SourceScene;      // read_mesh.h
struct MorphAnimation;  // mesh/morph_animation.h
struct SurfaceOrigin;   // surface_origin.h

/// What not every format can hold.
struct MeshFileOptions {
  /// A face attribute, one object NAME_VALUE per value: OBJ, GLB and USDA; empty: one object.
  std::string objects = {};
  /// GLB: each of `objects` is a closed solid: its origin is its centre of mass, its node's extras
  /// have its mass properties, and its convex hull is given so. None: they are just faces.
  std::optional<Collider> solids = {};
  /// GLB and USDA; null: nothing moves.
  const MorphAnimation* animation = nullptr;
  /// USDA, and OBJ without a library: how materials look, one per material of the mesh, and of
  /// picture files the paths that are to be written; write_mesh() writes pictures in memory beside
  /// the mesh, as NAME_1.png and so on. Null: plain.
  const std::vector<MaterialLook>* looks = nullptr;
  UpAxis up = UpAxis::automatic;  ///< USDA, which knows y and z; y where automatic
  double metres_per_unit = 0;     ///< USDA, of a mesh that does not say; 0: 1
  /// What the mesh was read with, to be written with it; null: the mesh alone.
  std::shared_ptr<const SourceScene> scene = {};
  /// How the mesh lies in the surface of `scene`; null: it is another surface, of the same
  /// materials.
  const SurfaceOrigin* origin = nullptr;
  /// GLB, of a mesh without corner normals: makes those that it is shaded with, 3 #F. Asked for
  /// once.
  std::function<std::vector<Vec3>()> normals = {};
  /// GLB: faces have been bent, and the mesh's normals are in place of the scene's.
  bool bent = false;
  /// GLB: edges to be drawn as lines, halfedges 3f+i from corner i to corner i+1 of face f.
  std::vector<std::int32_t> crack_edges = {};
  /// OBJ: the names after `mtllib`; empty: without. write_mesh() finds those of an OBJ file's
  /// scene.
  std::string material_library = {};
  /// Told, in one sentence each, what the format cannot hold; may be empty.
  std::function<void(const std::string&)> warn = {};
};

/// The bytes of a file of that format: "ply", "obj", "stl", "glb" or "usda". PLY keeps everything
/// but the seams' connectivity; OBJ keeps no attributes; STL only triangles; GLB is in single
/// precision and keeps no face attributes; USDA is in single precision. Reports "write". Throws
/// Error(usage) for another format or options that it has no place for, Error(request) for a mesh
/// it cannot hold, and Cancelled.
std::string format_mesh(const SurfaceMesh& mesh, std::string_view format,
                        const MeshFileOptions& options = {}, const Context& context = {});

/// Writes the format of the path's extension, whole or not at all. Throws as format_mesh does, and
/// Error(output) where the file cannot be written.
void write_mesh(const std::filesystem::path& path, const SurfaceMesh& mesh,
                const MeshFileOptions& options = {}, const Context& context = {});

/// Throws Error(usage) where the format of `path` cannot hold what the options ask for.
void check_mesh_file(const std::filesystem::path& path, bool objects, bool animation);

}  // namespace craze
