// What an OBJ file refers to and how it is divided.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "craze/io/source_scene.h"
#include "craze/surface_mesh.h"

namespace craze {

/// What the object of an `o` and a `g` is called, either of which may be empty.
std::string object_name(const std::string& o, const std::string& g);

struct ObjScene : SourceScene {
  std::filesystem::path folder;        ///< of the file, for what its libraries name
  std::vector<std::string> libraries;  ///< as `mtllib` names them
  std::string materials;               ///< their text, one after the other; "" where none is there
  std::map<std::string, std::string> pictures;               ///< bytes of its materials', by name
  std::vector<std::pair<std::string, std::string>> objects;  ///< `o` and `g`, by object of the mesh

  std::vector<SceneContent> contents() const override;
  /// `o` and `g` alone.
  std::vector<OtherName> other_names() const override;
};

/// Where a mesh of an OBJ file's finds its materials once it lies somewhere else.
struct ObjLibrary {
  std::string names;           ///< what `mtllib` says; "": nothing
  std::filesystem::path file;  ///< to be written; empty: nothing
  std::string text;            ///< what is written
};

/// The file's own libraries where they are still in reach and know all materials; else one beside
/// the mesh that holds their text, its pictures named from there, and side walls.
ObjLibrary library_beside(const std::filesystem::path& path, const ObjScene& scene,
                          const SurfaceMesh& mesh);

}  // namespace craze
