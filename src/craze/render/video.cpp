#include "craze/render/video.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <thread>
#include <vector>

#include "craze/base/text/format.h"
#include "craze/error.h"

namespace craze::render {

namespace fs = std::filesystem;

namespace {

constexpr int output_number = 3;  // of the output's descriptor in ffmpeg

/// What ffmpeg is started with as its own.
struct Descriptors {
  int input, messages, output;
};

/// Starts ffmpeg in a process group of its own, so that a Ctrl-C ends the run and not the video.
/// Returns 0 or the system's error.
int start(std::vector<std::string> arguments, const Descriptors& ours, pid_t& process) {
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, ours.input, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, ours.messages, STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&files, ours.output, output_number);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int error = posix_spawnp(&process, argv[0], &files, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

constexpr std::chrono::milliseconds moment{100};
constexpr std::size_t most_at_once = std::size_t{1} << 20;  // bytes

void wait_a_moment(const Context& context) {
  context.check();
  context.report({"video"});
  std::this_thread::sleep_for(moment / 10);
}

}  // namespace

bool has_ffmpeg() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path program = fs::path(folder) / "ffmpeg";
    std::error_code ignored;
    if (fs::is_regular_file(program, ignored) && access(program.c_str(), X_OK) == 0) return true;
  }
  return false;
}

Video::Video(const std::string& path, int width, int height, double frames_per_second)
    : path_(path) {
  const std::string format = fs::path(path).extension().string().substr(1);
  try {
    file_ = std::make_unique<FileBeside>(fs::absolute(path));
    if (file_->descriptor() < 0) fail(std::strerror(errno));
    messages_ = std::tmpfile();
    int ends[2];
    if (!messages_ || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
      fail(std::strerror(errno));
    }
    input_ = ends[0];
    const int error =
        start({"ffmpeg", "-loglevel", "error", "-nostdin", "-y", "-f", "rawvideo", "-pix_fmt",
               "rgb24", "-video_size", fmt::format("{}x{}", width, height), "-framerate",
               fmt::format("{}", frames_per_second), "-i", "pipe:0",
               // What every player can show: colours at half resolution, hence even sizes.
               "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-f", format,
               file_->path_by(output_number)},
              {ends[1], fileno(messages_), file_->descriptor()}, process_);
    close(ends[1]);
    if (error != 0) {
      process_ = -1;
      fail(error == ENOENT ? "ffmpeg was not found" : std::strerror(error));
    }
  } catch (...) {
    release();
    throw;
  }
}

Video::~Video() {
  release();
}

void Video::release() {
  if (input_ >= 0) close(input_);
  if (process_ > 0) {
    kill(-process_, SIGKILL);  // and what it has started
    waitpid(process_, nullptr, 0);
  }
  if (messages_) std::fclose(messages_);
  file_.reset();
}

void Video::add(const Image& image, const Context& context) {
  std::size_t sent = 0;
  while (sent < image.rgb.size()) {
    const std::size_t left = std::min(image.rgb.size() - sent, most_at_once);
    const ssize_t n = send(input_, image.rgb.data() + sent, left, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (n > 0) {
      sent += static_cast<std::size_t>(n);
    } else if (n < 0 && (errno == EAGAIN || errno == EINTR)) {
      wait_for_room(context);
    } else {
      while (!has_ended()) wait_a_moment(context);
      fail("ffmpeg stopped before the end");
    }
    context.check();
  }
}

void Video::finish(const Context& context) {
  close(input_);
  input_ = -1;
  while (!has_ended()) wait_a_moment(context);
  if (!succeeded_) fail("ffmpeg failed");
  if (const int error = file_->move_to(path_); error != 0) fail(std::strerror(error));
}

void Video::wait_for_room(const Context& context) {
  pollfd ready{input_, POLLOUT, 0};
  if (poll(&ready, 1, static_cast<int>(moment.count())) == 0) context.report({"video"});
}

bool Video::has_ended() {
  int status = 0;
  const pid_t ended = waitpid(process_, &status, WNOHANG);
  if (ended == 0) return false;
  succeeded_ = ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  process_ = -1;
  return true;
}

void Video::fail(const std::string& otherwise) {
  std::string said;
  if (messages_) {
    std::rewind(messages_);
    for (int c = std::fgetc(messages_); c != EOF && c != '\n'; c = std::fgetc(messages_)) {
      said += static_cast<char>(c);
    }
  }
  throw Error(ErrorKind::output, "cannot write the video", path_, said.empty() ? otherwise : said);
}

}  // namespace craze::render
