// Errors worth finding before a long computation.
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <vector>

#include "craze/base/error.h"
#include "craze/render/material.h"
#include "craze/scenario/run.h"

namespace craze {

namespace {

namespace fs = std::filesystem;

struct Output {
  const char* what;
  std::string path;
  std::vector<std::string> extensions;
};

std::string lower_extension_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void check_extension(const Output& output) {
  const auto& known = output.extensions;
  if (std::find(known.begin(), known.end(), lower_extension_of(output.path)) != known.end()) return;
  std::string list;
  for (const std::string& extension : known) list += (list.empty() ? "" : ", ") + extension;
  throw Error(ErrorKind::usage, std::string("cannot write ") + output.what, output.path,
              "the file must end in " + list);
}

void check_folder(const Output& output) {
  const auto fail = [&](const char* why) {
    throw Error(ErrorKind::output, std::string("cannot write ") + output.what, output.path, why);
  };
  std::error_code ignored;
  if (fs::is_directory(output.path, ignored)) fail("it is a folder");
  const fs::path parent = fs::path(output.path).parent_path();
  const fs::path folder = parent.empty() ? fs::path(".") : parent;
  if (!fs::is_directory(folder, ignored)) fail("its folder does not exist");
  // A device or pipe is written in place, anything else beside its place and renamed.
  const bool in_place =
      fs::exists(output.path, ignored) && !fs::is_regular_file(output.path, ignored);
  if (!in_place && access(folder.c_str(), W_OK) != 0) fail("its folder cannot be written");
}

}  // namespace

void check_picture_path(const std::string& path) {
  const Output picture{"the picture", path, {".png"}};
  check_extension(picture);
  check_folder(picture);
}

void check_request(const RunRequest& request) {
  const bool report_file = !request.report.empty() && request.report != "-";
  const std::string none;
  const std::vector<Output> outputs{
      {"the mesh", request.output, {".ply", ".obj", ".stl", ".glb"}},
      {"the crack lines", request.lines, {".ply", ".obj", ".svg", ".json"}},
      {"the picture", request.picture, {".png"}},
      {"the fields", request.fields, {".ply"}},
      {"the report", report_file ? request.report : none, {".json"}},
  };
  std::map<fs::path, const char*> taken;
  for (const Output& output : outputs) {
    if (output.path.empty()) continue;
    check_extension(output);
    check_folder(output);
    const auto [at, is_new] = taken.emplace(fs::path(output.path).lexically_normal(), output.what);
    if (!is_new) {
      throw Error(ErrorKind::usage, std::string("cannot write ") + output.what, output.path,
                  std::string("the same file is asked for ") + at->second);
    }
  }
  if (!request.frames.empty()) {
    // The folder itself may be new, the one it lies in may not.
    const fs::path frames = fs::path(request.frames) / "frame_0000.png";
    if (fs::exists(request.frames)) check_folder({"the frames", frames.string(), {}});
  }
  render::find_material(request.recipe.picture.material);
  if (taken.empty() && request.report.empty() && request.frames.empty()) {
    throw Error(ErrorKind::usage, "nothing to write", "",
                "give -o FILE, or one of --lines, --picture, --frames, --fields, --report");
  }
}

}  // namespace craze
