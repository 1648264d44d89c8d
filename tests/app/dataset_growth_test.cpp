#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/dataset_command.h"

namespace craze {
namespace {

using Bytes = std::map<std::string, std::string>;

/// Sets of the small plan with five samples, which end with a shard of one, and with eleven.
class DatasetGrowth : public Dataset {
 protected:
  DatasetGrowth() {
    std::string text = small_plan;
    write("plan.toml", text.replace(text.find("samples = 6"), 11, "samples = 5"));
  }

  CommandResult grow(const std::string& name, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"dataset", "plan.toml", "-o", name, "--samples", "11"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  bool is_whole(const std::string& name) { return run({"dataset", "verify", name}).code == 0; }

  /// That verify finds that in "set".
  void expect_fault(const std::string& text) {
    const CommandResult result = run({"dataset", "verify", "set"});
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.out.find(text), std::string::npos) << result.out;
  }

  void restore(const std::string& name, const Bytes& bytes) {
    std::filesystem::remove_all(file(name));
    for (const auto& [path, content] : bytes) {
      std::filesystem::create_directories(file(name + "/" + path).parent_path());
      std::ofstream(file(name + "/" + path), std::ios::binary) << content;
    }
  }
};

TEST_F(DatasetGrowth, EndsInTheBytesOfASetMadeAtOnce) {
  make("at_once", {"--samples", "11"});
  make("set");
  const auto begun = std::filesystem::last_write_time(file("set/shards/000001.tar"));
  const CommandResult grown = grow("set");
  EXPECT_EQ(grown.code, 0);
  EXPECT_EQ(grown.err,
            "craze: note: the set goes on from 5 samples to 11; shard 000002, which has 1 of its "
            "2, gets the others\n");
  EXPECT_NE(grown.out.find("4 made now"), std::string::npos) << grown.out;
  EXPECT_EQ(bytes_of("set"), bytes_of("at_once"));
  EXPECT_EQ(std::filesystem::last_write_time(file("set/shards/000001.tar")), begun);
  EXPECT_TRUE(is_whole("set"));
  EXPECT_EQ(grow("set").err, "");
}

TEST_F(DatasetGrowth, IsTheSameInStepsInShardsAndFromAnEditedPlan) {
  make("set", {"--samples", "1", "--quiet"});
  for (const char* shard : {"1/2", "2/2"}) make("set", {"--samples", "4", "--shard", shard});
  make("set", {"--samples", "7", "--shard", "1/3"});
  std::string text = small_plan;
  text.replace(text.find("samples = 6"), 12, "")
      .insert(text.find("[object]"), "samples=11 # all\n");
  write("plan.toml", text);
  for (const char* shard : {"0/3", "1/3", "2/3"}) make("set", {"--shard", shard, "--quiet"});
  make("at_once");
  EXPECT_EQ(bytes_of("set"), bytes_of("at_once"));
  write("plan.toml", text + "\n");
  const CommandResult other = run({"dataset", "plan.toml", "-o", "set", "--samples", "12"});
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.err.find("holds another plan"), std::string::npos) << other.err;
}

TEST_F(DatasetGrowth, KilledAtAnyMomentItIsNeverTakenForWholeAndEndsInTheSameBytes) {
  make("set");
  const Bytes small = bytes_of("set");
  const auto begin = std::chrono::steady_clock::now();
  make("at_once", {"--samples", "11"});
  const auto whole_run = std::chrono::steady_clock::now() - begin;
  const Bytes whole = bytes_of("at_once");
  int killed = 0, half = 0;
  for (int attempt = 0; attempt < 30; ++attempt) {
    if (attempt % 10 == 0) restore("set", small);
    const std::string shard = std::to_string(attempt % 3) + "/3";
    const pid_t process = start({"dataset", "plan.toml", "-o", "set", "--samples", "11", "--shard",
                                 shard, "--threads", "1"});
    std::this_thread::sleep_for(whole_run * (attempt % 10) * attempt / 600);
    kill(process, SIGKILL);
    killed += finish(process).code == 128 + SIGKILL;
    const Bytes now = bytes_of("set");
    half += now != small && now != whole;
    EXPECT_EQ(is_whole("set"), now == small || now == whole) << attempt;
  }
  EXPECT_GT(killed, 5);
  EXPECT_GT(half, 3);
  for (const char* shard : {"1/2", "2/2"}) EXPECT_EQ(grow("set", {"--shard", shard}).code, 0);
  EXPECT_EQ(bytes_of("set"), whole);
}

TEST_F(DatasetGrowth, FromAnyStateOfTheLastShardItEndsInTheSameBytes) {
  make("set");
  const Bytes small = bytes_of("set");
  ASSERT_EQ(grow("set").code, 0);
  const Bytes whole = bytes_of("set");
  // A kill between the renames: the archive is the fuller one, then its boxes are too.
  Bytes torn = small;
  for (const char* name : {"plan.toml", "shards/000002.tar", "shards/000002.coco.json"}) {
    torn[name] = whole.at(name);
    restore("set", torn);
    EXPECT_FALSE(is_whole("set")) << name;
    EXPECT_EQ(grow("set").code, 0);
    EXPECT_EQ(bytes_of("set"), whole) << name;
  }
  // What is not what its marker says is not gone on from.
  for (const char* name : {"shards/000002.tar", "shards/000002.coco.json"}) {
    Bytes damaged = small;
    damaged[name][damaged[name].size() / 2] ^= 1;
    restore("set", damaged);
    EXPECT_EQ(grow("set").code, 0);
    EXPECT_EQ(bytes_of("set"), whole) << name;
  }
}

TEST_F(DatasetGrowth, SamplesThatAreThereAreNotMadeAgain) {
  std::string text = read_text(file("plan.toml"));
  text.replace(text.find("shape:plate?n=14&jitter=0.3"), 27, "plate.obj");
  write("plan.toml", text);
  for (const char* shape : {"shape:plate?n=14&jitter=0.3", "shape:plate?n=15&jitter=0.3"}) {
    ASSERT_EQ(run({"crack", shape, "--set", "evolution.max_cracks=0", "-o", "plate.obj"}).code, 0);
    if (!std::filesystem::exists(file("set"))) make("set");
  }
  ASSERT_EQ(grow("set").code, 0);
  EXPECT_EQ(run({"dataset", "sample", "set", "5"}).code, 0) << "made now, of the second plate";
  EXPECT_EQ(run({"dataset", "sample", "set", "4"}).code, 1) << "kept, of the first one";
  EXPECT_TRUE(is_whole("set"));
}

TEST_F(DatasetGrowth, TheFolderAloneIsEnough) {
  std::string text = read_text(file("plan.toml"));
  write("plan.toml", text.replace(text.find("shape:plate?n=14&jitter=0.3"), 27, "plate.obj"));
  ASSERT_EQ(run({"crack", "shape:plate?n=14&jitter=0.3", "--set", "evolution.max_cracks=0", "-o",
                 "plate.obj"})
                .code,
            0);
  make("at_once", {"--samples", "11"});
  make("set");
  std::filesystem::remove(file("plan.toml"));
  const CommandResult grown = run({"dataset", "set/plan.toml", "-o", "set", "--samples", "11"});
  EXPECT_EQ(grown.code, 0) << grown.err;
  EXPECT_EQ(bytes_of("set"), bytes_of("at_once"));
}

TEST_F(DatasetGrowth, ADiskThatIsFullLeavesWhatThereWas) {
  make("at_once", {"--samples", "6"});
  make("set");
  const auto size = std::filesystem::file_size(file("set/shards/000002.tar"));
  const std::string call =
      "cd '" + file("").string() + "' && ulimit -f " + std::to_string(size / 512 + 20) +
      " && '" CRAZE_COMMAND "' dataset plan.toml -o set --samples 6 --quiet 2>full.err";
  EXPECT_NE(std::system(call.c_str()), 0);
  EXPECT_NE(read_text(file("full.err")).find("cannot write"), std::string::npos);
  EXPECT_EQ(std::filesystem::file_size(file("set/shards/000002.tar")), size);
  EXPECT_FALSE(is_whole("set"));
  make("set", {"--samples", "6"});
  EXPECT_EQ(bytes_of("set"), bytes_of("at_once"));
}

TEST_F(DatasetGrowth, ASmallerNumberIsRefusedAndNothingIsLost) {
  make("set", {"--samples", "11"});
  const Bytes before = bytes_of("set");
  for (const std::vector<std::string>& less :
       {std::vector<std::string>{"--samples", "10"}, {"--samples", "1"}, {}}) {
    std::vector<std::string> arguments{"dataset", "plan.toml", "-o", "set"};
    arguments.insert(arguments.end(), less.begin(), less.end());
    const CommandResult result = run(arguments);
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.err.find("11 samples there"), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
    EXPECT_EQ(bytes_of("set"), before);
  }
}

TEST_F(DatasetGrowth, APlanWhoseSamplesHangOnTheirNumberDoesNotGrow) {
  std::string text = read_text(file("plan.toml"));
  text.replace(text.find("{uniform = [1, 4]}"), 18, "{linked = \"samples\", factor = 0.3}");
  write("plan.toml", text);
  make("set");
  const CommandResult result = grow("set");
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("holds another plan"), std::string::npos) << result.err;
  EXPECT_TRUE(is_whole("set"));
}

TEST_F(DatasetGrowth, VerifyWantsTheSummaryOfTheseShardsAndNothingBeyond) {
  make("set");
  const Bytes small = bytes_of("set");
  ASSERT_EQ(grow("set").code, 0);
  const Bytes whole = bytes_of("set");
  for (const char* name : {"coco.json", "croissant.json", "dataset.json"}) {
    Bytes stale = whole;
    stale[name] = small.at(name);
    restore("set", stale);
    expect_fault(std::string(name) + " is not that of these shards");
    make("set", {"--samples", "11"});
    EXPECT_EQ(bytes_of("set"), whole);
  }
  for (const char* name : {"shards/000005.tar", "images/000000010.png", "masks/000000010.png"}) {
    Bytes more = small;
    more[name] = whole.at(name);
    restore("set", more);
    expect_fault(std::string(name) + " is beyond");
  }
  Bytes wrong = small;
  std::string& marker = wrong["shards/000000.json"];
  marker.replace(marker.find("\"clean\": "), 10, "\"clean\": 1");
  restore("set", wrong);
  EXPECT_FALSE(is_whole("set"));
}

TEST_F(DatasetGrowth, ARunOfTheSmallerSetGivesWayToTheLargerOne) {
  make("at_once", {"--samples", "11"});
  const pid_t smaller = start({"dataset", "plan.toml", "-o", "set", "--threads", "1"});
  while (!std::filesystem::exists(file("set/shards/000000.json"))) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  write("set/plan.toml", read_text(file("at_once/plan.toml")));  // another's claim
  const CommandResult gave_way = finish(smaller);
  EXPECT_EQ(gave_way.code, 2);
  EXPECT_NE(gave_way.err.find("plan is another one now"), std::string::npos) << gave_way.err;
  EXPECT_EQ(grow("set").code, 0);
  EXPECT_EQ(bytes_of("set"), bytes_of("at_once"));
}

TEST_F(DatasetGrowth, APlanInJsonGrowsToo) {
  write("plan.json", R"({"shard_samples": 2, "width": 32, "height": 32,
    "object": {"mesh": "shape:plate?n=12&jitter=0.3"}, "recipe": {"preset": "mud"}})");
  for (const char* samples : {"3", "5"}) {
    ASSERT_EQ(run({"dataset", "plan.json", "-o", "set", "--samples", samples}).code, 0);
  }
  ASSERT_EQ(run({"dataset", "plan.json", "-o", "at_once", "--samples", "5"}).code, 0);
  EXPECT_EQ(bytes_of("set"), bytes_of("at_once"));
}

}  // namespace
}  // namespace craze
