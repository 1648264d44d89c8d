// Where outputs go: each to a file of its own, whole, and whatever its name is.
#include "app/command.h"
#include "craze/read_mesh.h"

namespace craze {
namespace {

namespace fs = std::filesystem;
class OutputPlaces : public CommandTest {
 protected:
  OutputPlaces() : path_(std::getenv("PATH")) {}
  ~OutputPlaces() override { setenv("PATH", path_.c_str(), 1); }

  CommandResult crack(const Arguments& outputs) {
    Arguments arguments{"crack", "shape:plate?n=4", "--max-cracks", "0"};
    arguments.insert(arguments.end(), outputs.begin(), outputs.end());
    return run(arguments);
  }

  void expect_one_file(const Arguments& outputs) {
    const CommandResult result = crack(outputs);
    EXPECT_EQ(result.code, 2) << testing::PrintToString(outputs);
    EXPECT_NE(result.err.find("the same file is asked for"), std::string::npos) << result.err;
  }

  /// What a shell makes of the words after "craze crack shape:plate?n=4 --max-cracks 0".
  CommandResult in_shell(const std::string& before, const std::string& words) {
    const std::string command = "cd '" + (folder_ / "run").string() + "'; " + before + " '" +
                                CRAZE_COMMAND + "' crack 'shape:plate?n=40' --max-cracks 0 " +
                                words;
    const int status = std::system(command.c_str());
    return {WEXITSTATUS(status), "", read_text(folder_ / "err")};
  }

  const std::string path_;
};

TEST_F(OutputPlaces, OneFileByTwoNamesIsRefused) {
  const std::string here = file("").string();
  expect_one_file({"-o", "a.ply", "--fields", "a.ply"});
  expect_one_file({"-o", "a.ply", "--fields", "./a.ply"});
  expect_one_file({"-o", "a.ply", "--fields", here + "a.ply"});
  expect_one_file({"-o", "a.ply", "--fields", "../run/a.ply"});
  expect_one_file({"-o", "a.ply", "--fields", "/dev/.." + here + "a.ply"});
  EXPECT_TRUE(fs::is_empty(file("")));
}

TEST_F(OutputPlaces, OneFileByLinksIsRefused) {
  fs::create_symlink("a.ply", file("to_a.ply"));  // which is not there yet
  expect_one_file({"-o", "a.ply", "--fields", "to_a.ply"});
  fs::create_symlink(".", file("folder"));
  expect_one_file({"-o", "a.ply", "--lines", "folder/a.ply"});
  std::ofstream(file("a.ply")) << "older";
  expect_one_file({"-o", "a.ply", "--fields", "to_a.ply"});
  fs::create_hard_link(file("a.ply"), file("too.ply"));
  expect_one_file({"-o", "a.ply", "--fields", "too.ply"});
  EXPECT_EQ(read_text(file("a.ply")), "older");
}

TEST_F(OutputPlaces, AFrameThatIsAnOtherOutputIsRefused) {
  fs::create_directory(file("f"));
  expect_one_file({"--frames", "f", "--frame-format", "ply", "-o", "f/frame_0003.ply"});
  expect_one_file({"--frames", ".", "--picture", "frame_0000.png"});
  expect_one_file({"--frames", "a.ply", "-o", "a.ply"});
  EXPECT_EQ(crack({"--frames", "f", "--frame-count", "2", "--frame-format", "ply", "-o",
                   "f/frame_0003.ply"})
                .code,
            0);
}

TEST_F(OutputPlaces, TwoFilesAreTwo) {
  std::ofstream(file("a.ply")) << "older";
  std::ofstream(file("b.ply")) << "older";
  EXPECT_EQ(crack({"-o", "a.ply", "--fields", "b.ply"}).code, 0);
  EXPECT_EQ(crack({"-o", "c.ply", "--fields", "d.ply"}).code, 0);
}

TEST_F(OutputPlaces, AnOutputMayReplaceTheInputUnderAnyName) {
  ASSERT_EQ(crack({"-o", "a.ply"}).code, 0);
  fs::create_symlink("a.ply", file("b.ply"));
  const CommandResult result = run({"crack", "../run/a.ply", "-o", "b.ply", "--max-cracks", "0",
                                    "--set", "mesh.edge=0.05", "--set", "mesh.output=simulation"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(fs::is_symlink(file("b.ply")));
  EXPECT_GT(read_mesh_file(file("a.ply")).mesh.triangles.size(), 200u);
}

TEST_F(OutputPlaces, AnImpossibleFolderForFramesIsOneLine) {
  std::ofstream(file("text")) << "no folder";
  for (const std::string folder : {"text", "text/f", "/proc/none/f", "/dev/null/f"}) {
    const CommandResult result = crack({"--frames", folder});
    EXPECT_EQ(result.code, 1) << folder;
    EXPECT_EQ(result.err.find("craze: error: cannot write the frames"), 0u) << result.err;
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  }
}

TEST_F(OutputPlaces, TheVideoGoesWhereItsLinkLeads) {
  std::ofstream(folder_ / "ffmpeg") << "#!/bin/sh\nfor last; do true; done\ncat > \"$last\"\n";
  fs::permissions(folder_ / "ffmpeg", fs::perms::owner_all);
  setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
  fs::create_directory(file("videos"));
  fs::create_symlink("videos/real.mp4", file("v.mp4"));
  const Arguments small{"--frame-count", "1", "--width", "32", "--height", "24", "--samples", "1"};
  Arguments asked{"--video", "v.mp4"};
  asked.insert(asked.end(), small.begin(), small.end());
  const CommandResult result = crack(asked);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(fs::is_symlink(file("v.mp4")));
  EXPECT_EQ(fs::file_size(file("videos/real.mp4")), 3u * 32 * 24);
  fs::create_symlink("/dev/full", file("full.mp4"));
  asked[1] = "full.mp4";
  EXPECT_EQ(crack(asked).code, 1);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(OutputPlaces, ALimitOnFileSizesIsOneLine) {
  for (const char* output : {"-o a.ply", "-o a.glb", "--fields f.ply", "--report r.json"}) {
    const CommandResult result =
        in_shell("ulimit -f 1;", std::string(output) + " 2> ../err; exit $?");
    if (std::string(output) == "--report r.json") continue;  // small enough
    EXPECT_EQ(result.code, 1) << output;
    EXPECT_EQ(result.err.find("craze: error: "), 0u) << result.err;
    EXPECT_NE(result.err.find("File too large"), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  }
}

TEST_F(OutputPlaces, ClosedStreamsAreNotTakenForFiles) {
  EXPECT_EQ(in_shell("", "-o a.ply --set stress.uniform=0 --progress json 2>&- >&- <&-").code, 0);
  EXPECT_EQ(read_mesh_file(file("a.ply")).mesh.triangles.size(), 2u * 40 * 40);
  EXPECT_EQ(in_shell("", "--report - >&- 2> ../err").code, 1);
  EXPECT_NE(read_text(folder_ / "err").find("standard output"), std::string::npos);
}

TEST_F(OutputPlaces, NumbersAreReadAsPeopleWriteThem) {
  const CommandResult result =
      crack({"--report", "-", "--set", "post.gap=.06", "--set", "stress.uniform=2.", "--set",
             "seed=+7", "--set", "impact.0.point=[.25, -.5, 0.]", "--set", "impact.0.hoop=1."});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("\"gap\": 0.06"), std::string::npos) << result.out;
  EXPECT_EQ(crack({"--report", "-", "--set", "post.gap=."}).code, 2);
  EXPECT_EQ(crack({"--report", "-", "--set", "post.gap=1..2"}).code, 2);
}

}  // namespace
}  // namespace craze
