// Ctrl-C is heard within a second in every phase, and leaves no part of a file.
#include <sys/resource.h>
#include <sys/stat.h>

#include <chrono>
#include <set>
#include <thread>

#include "app/command.h"

namespace craze {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds nap{10};
constexpr std::chrono::seconds patience{120};  // however busy the machine is

double seconds_of(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

/// Seconds of processor time that a running process has used.
double used_by(pid_t process) {
  clockid_t clock{};
  timespec t{};
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &t) != 0) return 0;
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

class Stopping : public CommandTest {
 protected:
  Stopping() : path_(std::getenv("PATH")) {}
  ~Stopping() override { setenv("PATH", path_.c_str(), 1); }

  /// Puts a program of this name before all others.
  void fake(const std::string& name, const std::string& script) {
    std::ofstream(folder_ / name) << "#!/bin/sh\n" << script;
    fs::permissions(folder_ / name, fs::perms::owner_all);
    setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
  }

  /// Waits until the command is in the phase; false where it never is.
  bool reaches(pid_t process, const std::string& phase) {
    const auto end = Clock::now() + patience;
    while (Clock::now() < end) {
      if (read_text(folder_ / "err").find("{\"phase\":\"" + phase + "\"") != std::string::npos) {
        return true;
      }
      siginfo_t info{};
      if (waitid(P_PID, process, &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid != 0)
        break;
      std::this_thread::sleep_for(nap);
    }
    return false;
  }

  /// Sends the signal once the command is in the phase, and expects it to end with the code within
  /// a second of its own time. Time that others take on a busy machine does not count.
  void expect_stops(Arguments arguments, const std::string& phase, int signal = SIGINT,
                    int code = 130) {
    for (const char* more : {"--progress", "json", "--threads", "1"}) arguments.emplace_back(more);
    const pid_t process = start(arguments);
    if (!reaches(process, phase)) {
      kill(process, SIGKILL);
      FAIL() << "never in " << phase << ": " << finish(process).err;
    }
    std::this_thread::sleep_for(rest_);
    const double before = used_by(process);
    kill(process, signal);
    int status = 0;
    rusage usage{};
    const auto end = Clock::now() + patience;
    while (wait4(process, &status, WNOHANG, &usage) == 0) {
      if (Clock::now() > end) {
        kill(process, SIGKILL);
        waitpid(process, nullptr, 0);
        FAIL() << "deaf in " << phase;
      }
      std::this_thread::sleep_for(nap);
    }
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), code) << read_text(folder_ / "err");
    EXPECT_LT(seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime) - before, 1.0) << phase;
    const std::string said = read_text(folder_ / "err");
    const std::string last = "{\"error\":\"stopped\"}\n";
    EXPECT_EQ(said.substr(said.size() - std::min(said.size(), last.size())), last) << said;
  }

  std::set<std::string> files(const std::string& folder = ".") const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(file(folder))) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }

  const Arguments uncracked{"crack", "shape:plate?n=4", "--max-cracks", "0"};
  const std::string path_;
  std::chrono::milliseconds rest_{100};  // in the phase, before the signal
};

TEST_F(Stopping, WhileAMillionTrianglesAreRepaired) {
  expect_stops({"crack", "shape:plate?n=700", "-o", "a.ply", "--report", "r.json"}, "repair");
  EXPECT_EQ(files(), std::set<std::string>{});
}

TEST_F(Stopping, WhileAMeshIsMadeOfAMillionTriangles) {
  expect_stops({"crack", "shape:sphere", "-o", "a.ply", "--set", "mesh.edge=0.0025"}, "remesh");
  EXPECT_EQ(files(), std::set<std::string>{});
}

TEST_F(Stopping, WhileCurvatureIsMeasuredOverALargeRadius) {
  expect_stops({"crack", "shape:bumps?n=120", "-o", "a.ply", "--set", "mesh.edge=keep", "--set",
                "stress.curvature_radius=0.15", "--set", "stress.curvature=1"},
               "curvature");
  EXPECT_EQ(files(), std::set<std::string>{});
}

TEST_F(Stopping, BySigtermExitsWith143) {
  expect_stops({"crack", "shape:sphere", "-o", "a.ply", "--set", "mesh.edge=0.0025"}, "remesh",
               SIGTERM, 143);
}

TEST_F(Stopping, WhileALargePictureIsTaken) {
  const Arguments large{"--width", "4000", "--height", "4000", "--samples", "64"};
  expect_stops(uncracked + Arguments{"--picture", "p.png"} + large, "picture");
  expect_stops(Arguments{"render", "shape:cup", "-o", "p.png"} + large, "picture");
  EXPECT_EQ(files(), std::set<std::string>{});
}

TEST_F(Stopping, WhileAPictureOfManySamplesAPixelIsTaken) {
  expect_stops({"render", "shape:cup", "-o", "p.png", "--material", "glass", "--samples", "4096"},
               "picture");
  EXPECT_EQ(files(), std::set<std::string>{});
}

TEST_F(Stopping, WhileManyFramesAreTakenLeavesWholeOnes) {
  expect_stops(uncracked + Arguments{"--frames", "f", "--frame-count", "4000", "--width", "320",
                                     "--height", "240", "--samples", "4"},
               "frames");
  for (const std::string& name : files("f")) {
    const std::string png = read_text(file("f") / name);
    EXPECT_EQ(name.rfind("frame_", 0), 0u);
    EXPECT_NE(png.find("IEND"), std::string::npos) << name;
  }
}

TEST_F(Stopping, AStalledFfmpegAndWhatItHasStarted) {
  const Arguments video =
      uncracked + Arguments{"--video", "v.mp4", "--frame-count", "4", "--samples", "1"};
  const auto expect_no_sleeper = [&] {
    EXPECT_EQ(files(), std::set<std::string>{});
    const std::string sleeper = read_text(folder_ / "sleeper");
    ASSERT_FALSE(sleeper.empty());
    // What has been killed goes when a busy machine comes to it.
    const std::string file = "/proc/" + std::to_string(std::stol(sleeper)) + "/stat";
    std::string stat = read_text(file);
    const auto is_gone = [&] { return stat.empty() || stat.find(") Z") != std::string::npos; };
    for (const auto end = Clock::now() + patience; !is_gone() && Clock::now() < end;) {
      std::this_thread::sleep_for(nap);
      stat = read_text(file);
    }
    EXPECT_TRUE(is_gone()) << stat;
  };
  const std::string stall = "sleep 600 &\necho $! > ../sleeper\nwait\n";
  rest_ = std::chrono::seconds(2);
  fake("ffmpeg", stall);  // takes no picture
  expect_stops(video + Arguments{"--width", "400", "--height", "300"}, "frames");
  expect_no_sleeper();
  fake("ffmpeg", "cat > /dev/null\n" + stall);  // takes them all and never ends
  expect_stops(video + Arguments{"--width", "40", "--height", "30"}, "video");
  expect_no_sleeper();
}

TEST_F(Stopping, ByAKillLeavesNoPartOfAVideo) {
  // Says when it has begun and when it has ended, which it does only after the command.
  fake("ffmpeg",
       "for last; do true; done\nexec 5> \"$last\"\necho part >&5\n"
       "echo > ../begun\ncat > /dev/null\necho rest >&5\necho > ../ended\n");
  const pid_t process = start(uncracked + Arguments{"--video", "v.mp4", "--frame-count", "4000",
                                                    "--samples", "1", "--width", "400"});
  const auto wait_for = [&](const char* name) {
    const auto end = Clock::now() + patience;
    while (!fs::exists(folder_ / name) && Clock::now() < end) std::this_thread::sleep_for(nap);
    return fs::exists(folder_ / name);
  };
  EXPECT_TRUE(wait_for("begun"));
  kill(process, SIGKILL);
  finish(process);
  EXPECT_TRUE(wait_for("ended"));
  EXPECT_EQ(files(), std::set<std::string>{});
}

TEST_F(Stopping, AtAPipeThatNobodyWrites) {
  ASSERT_EQ(mkfifo(file("in.ply").c_str(), 0600), 0);
  expect_stops({"crack", "in.ply", "-o", "a.ply"}, "load");
  expect_stops({"render", "in.ply", "-o", "a.png"}, "load");
  EXPECT_EQ(files(), std::set<std::string>{"in.ply"});
}

TEST_F(Stopping, AtAPipeThatNobodyReads) {
  ASSERT_EQ(mkfifo(file("out.ply").c_str(), 0600), 0);
  expect_stops(uncracked + Arguments{"-o", "out.ply"}, "write");
  EXPECT_EQ(files(), std::set<std::string>{"out.ply"});
}

}  // namespace
}  // namespace craze
