// Pictures one after the other, as a video: by ffmpeg, where it is installed.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "craze/context.h"
#include "craze/io/files/file_beside.h"
#include "craze/render/image.h"

namespace craze::render {

/// Whether a program named ffmpeg lies in one of the folders of PATH.
bool has_ffmpeg();

/// Feeds ffmpeg; the path's extension is the format, mp4 or webm. Each call throws Error(output)
/// with the path and what ffmpeg says. An ffmpeg that stalls is waited for in steps
/// of a tenth of a second, each with a report, until the context cancels.
class Video {
 public:
  Video(const std::string& path, int width, int height, double frames_per_second);
  /// Without finish(), leaves nothing behind; nor does a kill.
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  /// All pictures have the size said at first. Waits for ffmpeg to take it; throws Cancelled.
  void add(const Image& image, const Context& context);
  /// Waits for ffmpeg and puts the file in its place; throws Cancelled.
  void finish(const Context& context);

 private:
  [[noreturn]] void fail(const std::string& otherwise);
  /// Whether ffmpeg has; `succeeded_` then says how.
  bool has_ended();
  /// For a moment, or until ffmpeg takes more.
  void wait_for_room(const Context& context);
  void release();

  std::string path_;
  std::unique_ptr<FileBeside> file_;
  int input_ = -1;
  int process_ = -1;  ///< the system's number of it
  bool succeeded_ = false;
  std::FILE* messages_ = nullptr;
};

}  // namespace craze::render
