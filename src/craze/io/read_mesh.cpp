#include "craze/read_mesh.h"

#include <optional>

#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/bytes/text_encoding.h"
#include "craze/io/files/extension.h"
#include "craze/io/files/read_file.h"
#include "craze/io/files/sibling_files.h"
#include "craze/io/mesh_formats.h"

namespace craze {

namespace {

const MeshFormat* recognise(std::string_view bytes) {
  for (const MeshFormat& format : mesh_formats()) {
    if (format.recognises && format.recognises(bytes)) return &format;
  }
  return nullptr;
}

std::string known_extensions() {
  std::string list;
  for (const MeshFormat& format : mesh_formats()) {
    if (format.read) list += fmt::format("{}.{}", list.empty() ? "" : " ", format.name);
  }
  return list;
}

}  // namespace

MeshFile read_mesh(std::string_view bytes, const std::string& name, const FileLoader& files,
                   const Context& context) {
  if (bytes.empty()) fail_input(name, "it is empty");
  const MeshFormat* format = recognise(bytes);
  std::optional<std::string> text;  // where the file's own bytes are not UTF-8 without a mark
  if (!format && has_byte_order_mark(bytes)) {
    text = decode_text(bytes, name);
    bytes = *text;
    format = recognise(bytes);
  }
  const std::string extension = lower_extension(name);
  if (!format) format = find_mesh_format(extension);
  if (!format || !format->read) {
    fail_input(name, fmt::format("'{}' is not a known extension ({})", printable(extension),
                                 known_extensions()));
  }
  MeshFile file;
  file.mesh = format->read(
      {bytes, name, files, context, file.warnings, file.textures, file.scene, &file.looks});
  context.report({"load", 1});
  return file;
}

MeshFile read_mesh_file(const std::filesystem::path& path, const Context& context) {
  const std::string bytes = read_file(path, "cannot read mesh", context);
  return read_mesh(bytes, path.string(), load_from_folder(path.parent_path(), context), context);
}

FileLoader load_from_memory(std::map<std::string, std::string> files) {
  return [files = std::move(files)](const std::string& uri) {
    const auto found = files.find(uri);
    if (found == files.end()) fail_input(printable(uri), "this file was not given");
    return found->second;
  };
}

}  // namespace craze
