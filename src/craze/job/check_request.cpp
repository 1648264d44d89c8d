// Errors worth finding before a long computation.
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <vector>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/files/extension.h"
#include "craze/job/output_folder.h"
#include "craze/job/output_place.h"
#include "craze/job/run.h"
#include "craze/material/material.h"
#include "craze/recipe/check_recipe.h"
#include "craze/render/video.h"
#include "craze/write_mesh.h"

namespace craze {

namespace {

namespace fs = std::filesystem;

struct Output {
  const char* what;
  std::string path;
  std::vector<std::string> extensions;
};

void check_extension(const Output& output) {
  const auto& known = output.extensions;
  if (std::find(known.begin(), known.end(), lower_extension(output.path)) != known.end()) return;
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

/// Where the outputs go: each to a file of its own, by whatever name it is asked for.
class Places {
 public:
  bool empty() const { return !any_; }

  void take(const char* what, const fs::path& path) {
    any_ = true;
    std::error_code ignored;
    if (fs::is_character_file(path, ignored)) return;  // swallows any number
    const auto [at, is_new] = taken_.emplace(place_of(path), what);
    if (is_new) return;
    throw Error(ErrorKind::usage, std::string("cannot write ") + what, path.string(),
                std::string("the same file is asked for ") + at->second);
  }

 private:
  bool any_ = false;
  std::map<std::string, const char*> taken_;
};

/// ffmpeg's file is put in its place whole, and only a file has one.
void check_video(const std::string& video) {
  std::error_code ignored;
  const fs::path target = followed(video);
  if (!fs::exists(target, ignored) || fs::is_regular_file(target, ignored)) return;
  throw Error(ErrorKind::output, "cannot write the video", video, "it is a device or a pipe");
}

void check_frames(const RunRequest& request, Places& places) {
  const auto frame = [&](int i) {
    return fs::path(request.frames) / fmt::format("frame_{:04}.{}", i, request.frame_format);
  };
  std::error_code ignored;
  if (fs::exists(request.frames, ignored)) {
    check_folder({"the frames", frame(0).string(), {}});
  } else {
    check_output_folder("the frames", request.frames);
  }
  places.take("the frames", request.frames);
  for (int i = 0; i < request.frame_count; ++i) places.take("the frames", frame(i));
}

void check_maps(const MapsRequest& maps, Places& places) {
  check_output_folder("the maps", maps.folder);
  places.take("the maps", maps.folder);
  places.take("the maps", fs::path(maps.folder) / "maps.json");
}

/// Asked for together, what makes no sense alone.
void check_growth(const RunRequest& request) {
  const auto wrong = [](const char* what, const std::string& where, const char* why) {
    throw Error(ErrorKind::usage, what, where, why);
  };
  const bool any = request.animate || request.split_fragments;
  if (any && request.output.empty()) {
    wrong("cannot write the mesh", request.animate ? "--animate" : "--fragments",
          "give the file: -o FILE.glb");
  }
  if (any) check_mesh_file(request.output, request.split_fragments, request.animate);
  if (request.animate && request.recipe.post.gap == 0 &&
      request.recipe.post.gap_width.number() == 0) {
    wrong("nothing would move", "--animate",
          "the cracks stay shut; open them, for example with --set post.gap=0.05");
  }
  const std::vector<std::string> formats{"png", "ply", "obj", "stl", "glb"};
  if (std::find(formats.begin(), formats.end(), request.frame_format) == formats.end()) {
    wrong("cannot write the frames", request.frame_format,
          "the format must be png, ply, obj, stl or glb");
  }
  if (!request.video.empty() && !render::has_ffmpeg()) {
    throw Error(ErrorKind::request, "cannot write the video", request.video,
                "ffmpeg is not installed; with --frames DIR the pictures are written one by one");
  }
}

void check_mapped(const RunRequest& request) {
  const auto wrong = [](const std::string& where, const char* why) {
    throw Error(ErrorKind::usage, "cannot write the mapped mesh", where, why);
  };
  if (request.output.empty()) wrong("--as maps", "give the file: -o FILE.glb");
  if (lower_extension(request.output) != ".glb") wrong(request.output, "the file must end in .glb");
  if (request.animate || request.split_fragments) {
    wrong(request.animate ? "--animate" : "--fragments", "its triangles are not cut");
  }
}

}  // namespace

bool takes_pictures(const RunRequest& request) {
  const bool frames = !request.frames.empty() && request.frame_format == "png";
  return !request.picture.empty() || !request.video.empty() || frames;
}

void check_picture_path(const std::string& path) {
  const Output picture{"the picture", path, {".png"}};
  check_extension(picture);
  check_folder(picture);
}

void check_request(const RunRequest& request) {
  check_recipe(request.recipe);
  const bool report_file = !request.report.empty() && request.report != "-";
  const std::string none;
  const std::vector<Output> outputs{
      {"the mesh", request.output, {".ply", ".obj", ".stl", ".glb", ".usda"}},
      {"the crack lines", request.lines, {".ply", ".obj", ".svg", ".json"}},
      {"the picture", request.picture, {".png"}},
      {"the video", request.video, {".mp4", ".webm"}},
      {"the fields", request.fields, {".ply"}},
      {"the report", report_file ? request.report : none, {".json"}},
  };
  Places places;
  for (const Output& output : outputs) {
    if (output.path.empty()) continue;
    check_extension(output);
    check_folder(output);
    places.take(output.what, output.path);
  }
  if (!request.video.empty()) check_video(request.video);
  if (!request.frames.empty()) check_frames(request, places);
  if (!request.maps.folder.empty()) check_maps(request.maps, places);
  check_growth(request);
  if (request.as_maps) check_mapped(request);
  render::find_material(request.recipe.picture.material);
  if (places.empty() && request.report.empty() && request.frames.empty()) {
    throw Error(ErrorKind::usage, "nothing to write", request.input,
                "give -o FILE, or one of --lines, --picture, --frames, --video, --maps, --fields, "
                "--report");
  }
}

}  // namespace craze
