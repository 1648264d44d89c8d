// Pictures one after the other, as a video: by ffmpeg, where it is installed.
#pragma once

#include <cstdio>
#include <string>

#include "craze/render/image.h"

namespace craze::render {

/// Whether a program named ffmpeg lies in one of the folders of PATH.
bool has_ffmpeg();

/// Feeds ffmpeg, which chooses the format by the extension of the path. Each call throws
/// Error(output) with the path and what ffmpeg says.
class Video {
 public:
  Video(const std::string& path, int width, int height, double frames_per_second);
  /// Without finish(), leaves nothing behind.
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  /// All pictures have the size said at first.
  void add(const Image& image);
  /// Waits for ffmpeg and puts the file in its place.
  void finish();

 private:
  [[noreturn]] void fail(const std::string& otherwise);
  bool wait();
  void release();

  std::string path_, partial_;
  int input_ = -1;
  int process_ = -1;  ///< the system's number of it
  std::FILE* messages_ = nullptr;
};

}  // namespace craze::render
