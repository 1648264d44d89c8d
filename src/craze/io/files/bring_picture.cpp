#include "craze/io/files/bring_picture.h"

#include <utility>

#include "craze/error.h"
#include "craze/io/files/file_names.h"
#include "craze/io/image/picture_type.h"

namespace craze {

BroughtPicture bring_picture(const std::string& name, const MeshSource& source) {
  if (!source.files) return {{}, "no files are read here"};
  try {
    std::string bytes = source.files(name);
    if (picture_type(bytes).empty()) return {{}, "no PNG or JPEG"};
    return {std::move(bytes), {}};
  } catch (const Error&) {
    const bool leads_out = is_absolute_name(name) || name.starts_with("../");
    return {{}, leads_out ? "not in the model's folder" : "not found"};
  }
}

}  // namespace craze
