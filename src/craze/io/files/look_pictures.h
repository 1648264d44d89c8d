// Pictures that only the input holds, written beside the output.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "craze/context.h"
#include "craze/material_look.h"

namespace craze {

/// Names them NAME_1.png, NAME_2.jpg …, NAME being the output's without its extension, in the order
/// in which they are asked for. Numbers whose file exists with other bytes are left out: it may be
/// the input's own.
class LookPictures {
 public:
  explicit LookPictures(std::filesystem::path output) : output_(std::move(output)) {}

  /// The file of a picture as seen from the folder of the output; empty where there is none.
  std::string name_of(const LookPicture& picture);
  /// Throws Error(output) and Cancelled.
  void write(const Context& context) const;

 private:
  std::filesystem::path output_;
  std::map<const std::string*, std::string> names_;
  std::vector<std::pair<std::filesystem::path, std::shared_ptr<const std::string>>> files_;
  int number_ = 0;  // of the last name
};

/// The looks, their pictures all files.
std::vector<MaterialLook> looks_with_files(std::vector<MaterialLook> looks, LookPictures& pictures);

}  // namespace craze
