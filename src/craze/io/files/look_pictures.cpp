#include "craze/io/files/look_pictures.h"

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/files/atomic_file.h"
#include "craze/io/files/read_file.h"
#include "craze/io/image/picture_type.h"

namespace craze {

namespace {

std::string extension_of(const std::string& bytes) {
  const std::string type = picture_type(bytes);
  if (type.empty()) return "";
  return type == "image/jpeg" ? ".jpg" : "." + type.substr(type.find('/') + 1);
}

bool is_other_file(const std::filesystem::path& path, const std::string& bytes) {
  std::error_code ignored;
  if (!std::filesystem::exists(std::filesystem::symlink_status(path, ignored))) return false;
  try {
    return !std::filesystem::is_regular_file(path, ignored) || read_file(path) != bytes;
  } catch (const Error&) {
    return true;
  }
}

}  // namespace

std::string LookPictures::name_of(const LookPicture& picture) {
  if (!picture.bytes) return picture.file;
  const auto [found, is_new] = names_.try_emplace(picture.bytes.get());
  if (is_new) {
    const std::string extension = extension_of(*picture.bytes);
    do {
      found->second = fmt::format("{}_{}{}", output_.stem().string(), ++number_, extension);
    } while (is_other_file(output_.parent_path() / found->second, *picture.bytes));
    files_.emplace_back(output_.parent_path() / found->second, picture.bytes);
  }
  return found->second;
}

void LookPictures::write(const Context& context) const {
  for (const auto& [file, bytes] : files_) {
    write_file(file, *bytes, "cannot write a texture", context);
  }
}

std::vector<MaterialLook> looks_with_files(std::vector<MaterialLook> looks,
                                           LookPictures& pictures) {
  for (MaterialLook& look : looks) {
    for_each_picture(look, [&](LookPicture& picture) {
      picture.file = pictures.name_of(picture);
      picture.bytes = nullptr;
    });
  }
  return looks;
}

}  // namespace craze
