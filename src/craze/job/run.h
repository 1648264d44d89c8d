// The command's run: from a file or shape to every output asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "craze/context.h"
#include "craze/job/load_textures.h"
#include "craze/job/maps/write_maps.h"
#include "craze/length.h"
#include "craze/products/maps/pictures/crack_pictures.h"
#include "craze/recipe.h"
#include "craze/render/picture.h"
#include "craze/report.h"

namespace craze {

/// What to crack and what to write. An empty path: not asked for.
struct RunRequest {
  std::string input;  ///< a file, or "shape:NAME?key=value&…"
  Recipe recipe;
  TextureFolder textures;  ///< of the recipe's file
  /// Crack events to stop after; unlike evolution.max_cracks, 0 means none: the initial state.
  std::optional<std::int64_t> max_cracks;

  std::string output;   ///< the cracked mesh: .ply .obj .stl .glb .usda
  std::string lines;    ///< the cracks: .ply .obj .svg .json
  std::string picture;  ///< .png
  std::string frames;   ///< a folder, made if need be: frame_0000 … of the growth
  int frame_count = 24;
  std::string frame_format = "png";  ///< pictures, or meshes: ply, obj, stl, glb
  std::string video;                 ///< the frames' pictures as .mp4 or .webm; needs ffmpeg
  bool animate = false;              ///< `output`, .glb or .usda, plays the growth
  int animation_stages = 32;         ///< morph targets of it
  double clip_seconds = 4;           ///< how long the growth takes there and in the video
  bool split_fragments = false;      ///< `output`, not .ply or .stl, has an object per fragment
  /// How pictures are taken. Material and upward axis are the recipe's.
  render::PictureOptions shot;
  Length line_width = 0;    ///< of cracks in pictures, instead of the shot's; 0: by the size
  std::string environment;  ///< the file of the picture that lights them; empty: the studio
  /// `output`, .glb, is the input's scene with the cracks in its materials' pictures alone.
  bool as_maps = false;
  CrackStain stain;    ///< of as_maps
  bool plain = false;  ///< in the material's colours, not in those of the input's own materials
  MapsRequest maps;    ///< maps of the cracks; gap and wall are the recipe's
  std::string fields;  ///< stress, forces and curvatures at the end: .ply
  std::string report;  ///< .json, or "-": only in the result
};

/// Whether a picture is asked for: one, or those of frames or of a video.
bool takes_pictures(const RunRequest& request);

struct RunResult {
  Report report;
  std::string report_text;  ///< what the report file holds: JSON (products/report_json.h)
  bool cancelled = false;   ///< stopped by the context; the outputs hold the state then
};

/// Finds before any work what would fail after it: an output of a wrong kind (Error(usage)), a
/// folder that does not exist or cannot be written, two outputs in one file, nothing asked for, a
/// recipe that says one thing in two ways.
void check_request(const RunRequest& request);

/// The same for a picture alone.
void check_picture_path(const std::string& path);

/// Loads, repairs, cracks and writes, after check_request. Each file is whole or not there. Throws
/// Error: input that cannot be read or used, files that cannot be written. Throws Cancelled where
/// the context cancels before the first crack or while the files of a whole run are written.
RunResult run(const RunRequest& request, const Context& context);

}  // namespace craze
