// What a reader of meshes is given, and where it says what it left out.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "craze/context.h"
#include "craze/io/source_scene.h"
#include "craze/read_mesh.h"

namespace craze {

/// One reading of one file. What it refers to must outlive it.
struct MeshSource {
  std::string_view bytes;
  const std::string& name;             ///< of the file, for messages
  const FileLoader& files;             ///< empty: no other file is opened
  const Context& context;              ///< readers report "load" and throw Cancelled
  std::vector<std::string>& warnings;  ///< one sentence for each kind of thing that was left out
  std::vector<std::string>& textures;  ///< pictures that the file names, in its own words
  std::shared_ptr<const SourceScene>& scene;   ///< what else the file holds; may stay null
  std::vector<MaterialLook>* looks = nullptr;  ///< MeshFile::looks; null: not wanted

  void warn(std::string sentence) const { warnings.push_back(std::move(sentence)); }
};

}  // namespace craze
