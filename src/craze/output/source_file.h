// What a run's surface was read from.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "craze/read_mesh.h"

namespace craze {

/// What a file brought besides its surface.
struct SourceFile {
  std::string name;                          ///< a path, or "shape:…" of a built-in one
  std::vector<MaterialLook> looks;           ///< as MeshFile has them
  std::shared_ptr<const SourceScene> scene;  ///< null: nothing
};

/// Whether the name is that of a built-in shape, "shape:…"; such stand along z.
bool is_shape(std::string_view name);

/// The looks with the texture files as seen from the folder of `output`, named from that of
/// `input`.
std::vector<MaterialLook> looks_from(const std::vector<MaterialLook>& looks,
                                     const std::string& input, const std::string& output);

}  // namespace craze
