#include <sys/stat.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/dataset_command.h"

namespace craze {
namespace {

TEST_F(Dataset, IsWholeAndSaysWhatItHolds) {
  make("set");
  const CommandResult verified = run({"dataset", "verify", "set"});
  EXPECT_EQ(verified.code, 0) << verified.out;
  const auto json = nlohmann::json::parse(read_text(file("set/dataset.json")));
  EXPECT_EQ(json["samples"], 6);
  EXPECT_GT(json["crack_share"].get<double>(), 0);
  EXPECT_GT(json["median_width_pixels"].get<double>(), 1);
  EXPECT_LT(json["median_width_pixels"].get<double>(), 4.5);
  EXPECT_EQ(nlohmann::json::parse(read_text(file("set/coco.json")))["images"].size(), 6u);
  EXPECT_EQ(nlohmann::json::parse(read_text(file("set/croissant.json")))["@type"], "sc:Dataset");
  EXPECT_TRUE(std::filesystem::exists(file("set/images/000000005.png")));
  EXPECT_TRUE(std::filesystem::exists(file("set/masks/000000005.png")));
}

TEST_F(Dataset, AnyShardsAndThreadsGiveTheSameBytes) {
  make("one", {"--threads", "1"});
  for (const char* shard : {"0/2", "1/2"}) make("two", {"--threads", "3", "--shard", shard});
  EXPECT_EQ(bytes_of("one"), bytes_of("two"));
}

TEST_F(Dataset, KilledAtAnyMomentItGoesOnToTheSameBytes) {
  const auto begin = std::chrono::steady_clock::now();
  make("whole");
  const auto a_shard = (std::chrono::steady_clock::now() - begin) / 3;
  int killed = 0;
  for (int attempt = 0; attempt < 30; ++attempt) {
    const std::string shard = std::to_string(attempt % 3) + "/3";
    const pid_t process =
        start({"dataset", "plan.toml", "-o", "cut", "--shard", shard, "--threads", "1"});
    // More early moments than late ones: the first run may have been slower.
    std::this_thread::sleep_for(a_shard * attempt * attempt / 900);
    kill(process, SIGKILL);
    killed += finish(process).code == 128 + SIGKILL;
  }
  EXPECT_GT(killed, 5);
  make("cut", {"--shard", "1/2"});
  make("cut", {"--shard", "2/2"});
  EXPECT_EQ(bytes_of("whole"), bytes_of("cut"));
}

TEST_F(Dataset, ATornShardIsMadeAgain) {
  make("set");
  const auto whole = bytes_of("set");
  write("set/shards/000001.tar", whole.at("shards/000001.tar").substr(0, 5000));
  EXPECT_EQ(run({"dataset", "verify", "set"}).code, 1);
  make("set");
  std::filesystem::remove(file("set/shards/000002.json"));
  make("set");
  EXPECT_EQ(bytes_of("set"), whole);
}

TEST_F(Dataset, OneChangedByteIsFound) {
  make("set");
  for (const char* name : {"set/shards/000001.tar", "set/shards/000000.coco.json"}) {
    const std::string bytes = read_text(file(name));
    std::string changed = bytes;
    changed[bytes.size() / 2] ^= 1;
    write(name, changed);
    const CommandResult result = run({"dataset", "verify", "set"});
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.out.find("not what its marker says"), std::string::npos) << result.out;
    write(name, bytes);
  }
  EXPECT_EQ(run({"dataset", "verify", "set"}).code, 0);
}

TEST_F(Dataset, ASampleIsMadeAgainFromItsNumber) {
  make("set");
  const CommandResult same = run({"dataset", "sample", "set", "3", "-o", "three"});
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  EXPECT_TRUE(std::filesystem::exists(file("three/000000003.mask.png")));
  EXPECT_EQ(read_text(file("three/000000003.image.png")),
            read_text(file("set/images/000000003.png")));
  const CommandResult none = run({"dataset", "sample", "set", "6"});
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("no sample 6"), std::string::npos);
}

TEST_F(Dataset, MoreSamplesLeaveThoseThereWereAsTheyAre) {
  make("six");
  make("eight", {"--samples", "8"});
  const auto six = bytes_of("six"), eight = bytes_of("eight");
  EXPECT_EQ(six.at("images/000000005.png"), eight.at("images/000000005.png"));
  EXPECT_TRUE(eight.count("images/000000007.png"));
}

TEST_F(Dataset, AContactSheetShowsTheSamples) {
  make("set");
  EXPECT_EQ(run({"dataset", "look", "set", "--size", "40", "--count", "4"}).code, 0);
  EXPECT_EQ(read_text(file("set/look.png")).substr(1, 3), "PNG");
}

TEST_F(Dataset, APlanThatCannotYieldSaysSo) {
  write("none.toml", std::string(small_plan) + "[label]\nmin_pixels = 100000\n");
  const CommandResult result = run({"dataset", "none.toml", "-o", "none"});
  EXPECT_EQ(result.code, 1);
  EXPECT_NE(result.err.find("the plan yields no crack that is seen"), std::string::npos)
      << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1);
}

TEST_F(Dataset, HostilePlansAreRefusedInOneLine) {
  const std::pair<const char*, const char*> cases[] = {
      {"samples = 0", "samples"},
      {"widht = 3", "did you mean width"},
      {"[lines]\nwidth = {uniform = [0, 3]}", "lines.width"},
      {"[object]\nmesh = 3", "must be text"},
      {"[surface]\nmaterial = \"gold\"", "choose one of"},
      {"[recipe]\npreset = \"marble\"", "bad.toml:2:10"},
      {"[recipe]\npost.gap = 0.1", "no recipe.post.gap in a dataset"},
      {"samples = 1000000000\nshard_samples = 1", "too many shards"},
  };
  for (const auto& [text, words] : cases) {
    write("bad.toml", text);
    const CommandResult result = run({"dataset", "bad.toml", "-o", "bad"});
    EXPECT_EQ(result.code, 2) << text;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
    EXPECT_FALSE(std::filesystem::exists(file("bad")));
  }
  write("none.toml", "samples = 1\n[object]\nmesh = \"none.obj\"\n");
  const CommandResult none = run({"dataset", "none.toml", "-o", "none"});
  EXPECT_EQ(none.code, 1);
  EXPECT_NE(none.err.find("none.obj"), std::string::npos) << none.err;
  EXPECT_FALSE(std::filesystem::exists(file("none")));
}

TEST_F(Dataset, OfAFolderOfMeshesOnlyThoseAreTaken) {
  std::string text = small_plan;
  write("plan.toml", text.replace(text.find("shape:plate?n=14&jitter=0.3"), 27, "scans"));
  std::filesystem::create_directories(file("scans/folder.obj"));
  write("scans/read_me.txt", "none of them");
  ASSERT_EQ(mkfifo(file("scans/pipe.obj").c_str(), 0644), 0);
  const CommandResult none = run({"dataset", "plan.toml", "-o", "set"});
  EXPECT_EQ(none.code, 1);
  EXPECT_NE(none.err.find("no meshes in the folder"), std::string::npos) << none.err;
  EXPECT_FALSE(std::filesystem::exists(file("set")));
  ASSERT_EQ(run({"crack", "shape:plate?n=14&jitter=0.3", "--set", "evolution.max_cracks=0", "-o",
                 "scans/plate.obj"})
                .code,
            0);
  make("set");
}

TEST_F(Dataset, DamagedFoldersAreRefusedInOneLine) {
  make("set");
  const auto whole = bytes_of("set");
  std::string archive = whole.at("shards/000000.tar");
  archive.replace(archive.find("{\"id\""), 6, "[[[[[[");
  const struct {
    std::string name, bytes;
    std::vector<std::string> command;
    std::string words;
  } cases[] = {
      {"made_by.json", "[]", {"dataset", "verify", "set"}, "it is damaged"},
      {"made_by.json", "{\"kind\": 3}", {"dataset", "look", "set"}, "it is damaged"},
      {"shards/000000.tar", archive, {"dataset", "look", "set"}, "cannot show a sample"},
      {"shards/000001.coco.json", "{", {"dataset", "plan.toml", "-o", "set"}, "remove that file"},
  };
  for (const auto& c : cases) {
    write("set/" + c.name, c.bytes);
    const CommandResult result = run(c.command);
    EXPECT_EQ(result.code, 1) << c.name;
    EXPECT_NE(result.err.find(c.words), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
    write("set/" + c.name, whole.at(c.name));
  }
  std::filesystem::remove(file("set/shards/000001.coco.json"));
  make("set");
  EXPECT_EQ(bytes_of("set"), whole);
}

TEST_F(Dataset, VerifyFindsWhatIsNotThePlansAndWhatIsNotTheArchives) {
  make("set");
  const std::pair<std::string, std::string> cases[] = {
      {"masks/000000001.png", "masks/000000001.png is not what its archive has"},
      {"plan.toml", "is of another plan than plan.toml"},
      {"shards/000000.json", "not whole"},
  };
  for (const auto& [name, words] : cases) {
    const std::string bytes = read_text(file("set/" + name));
    std::string changed = bytes + "\n";
    if (const auto at = changed.find("\"first\": 0"); at != std::string::npos)
      changed[at + 9] = '4';
    write("set/" + name, changed);
    const CommandResult result = run({"dataset", "verify", "set"});
    EXPECT_EQ(result.code, 1) << name;
    EXPECT_NE(result.out.find(words), std::string::npos) << result.out;
    write("set/" + name, bytes);
  }
  EXPECT_EQ(run({"dataset", "verify", "set"}).code, 0);
}

TEST_F(Dataset, WhatIsMissingBesideTheArchivesIsWrittenFromThem) {
  make("set");
  const auto whole = bytes_of("set");
  std::filesystem::remove_all(file("set/masks"));
  std::filesystem::remove(file("set/images/000000003.png"));
  EXPECT_EQ(run({"dataset", "verify", "set"}).code, 1);
  const CommandResult again = run({"dataset", "plan.toml", "-o", "set"});
  EXPECT_NE(again.out.find("0 made now"), std::string::npos) << again.out;
  EXPECT_EQ(bytes_of("set"), whole);
  std::filesystem::remove(file("set/images/000000003.png"));
  std::filesystem::create_directory(file("set/images/000000003.png"));
  const CommandResult blocked = run({"dataset", "plan.toml", "-o", "set"});
  EXPECT_EQ(blocked.code, 1);
  EXPECT_NE(blocked.err.find("(set/images/000000003.png): Is a directory"), std::string::npos)
      << blocked.err;
}

TEST_F(Dataset, ThatIsWholeIsNotWrittenAgain) {
  make("set");
  std::map<std::string, std::filesystem::file_time_type> times;
  for (const auto& [name, bytes] : bytes_of("set")) {
    times[name] = std::filesystem::last_write_time(file("set/" + name));
  }
  make("set", {"--shard", "1/18446744073709551615"});
  for (const auto& [name, time] : times) {
    EXPECT_EQ(std::filesystem::last_write_time(file("set/" + name)), time) << name;
  }
}

TEST_F(Dataset, WhatIsNoSetIsSaidSo) {
  write("sweep.toml", "object = \"shape:plate?n=8\"\n");
  ASSERT_EQ(run({"sweep", "sweep.toml", "-o", "table"}).code, 0);
  std::filesystem::create_directory(file("empty"));
  const std::pair<const char*, const char*> cases[] = {
      {"none", "no dataset (none): there is no such folder"},
      {"empty", "no dataset (empty): it has no made_by.json"},
      {"table", "no dataset (table): it holds a sweep"},
      {"plan.toml", "no dataset (plan.toml): there is no such folder"}};
  for (const auto& [folder, words] : cases) {
    for (const char* verb : {"verify", "look"}) {
      const CommandResult result = run({"dataset", verb, folder});
      EXPECT_EQ(result.code, 1);
      EXPECT_EQ(result.err, std::string("craze: error: ") + words + "\n");
    }
  }
  make("set");
  const CommandResult jpeg = run({"dataset", "look", "set", "-o", "sheet.jpg"});
  EXPECT_EQ(jpeg.code, 2);
  EXPECT_NE(jpeg.err.find("must end in .png"), std::string::npos) << jpeg.err;
}

TEST_F(Dataset, ManyShardsThatAreMissingAreOneLine) {
  make("set", {"--samples", "20000", "--shard", "10000/10000"});
  const CommandResult result = run({"dataset", "verify", "set"});
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(result.out,
            "shards 000001 to 009999: they are not there, or not whole\n"
            "remove the files that are not, and make the set again\n");
}

TEST_F(Dataset, RoughLinesAreOfTheRecipe) {
  make("rough");
  write("plan.toml",
        std::string(small_plan)
            .replace(std::string(small_plan).find("preset"), 0, "post.relative_roughness = 0\n"));
  make("smooth");
  const auto smooth = bytes_of("smooth"), rough = bytes_of("rough");
  int other = 0;
  for (const auto& [name, bytes] : smooth) {
    if (name.rfind("masks/", 0) == 0) other += rough.at(name) != bytes;
  }
  EXPECT_GT(other, 2);
}

TEST_F(Dataset, ADiskThatIsFullLeavesNothingHalf) {
  make("whole");
  const std::string call = "cd '" + file("").string() +
                           "' && ulimit -f 20 && '" CRAZE_COMMAND
                           "' dataset plan.toml -o full --quiet 2>full.err";
  EXPECT_NE(std::system(call.c_str()), 0);
  EXPECT_NE(read_text(file("full.err")).find("cannot write"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(file("full/shards/000000.json")));
  make("full");
  EXPECT_EQ(bytes_of("full"), bytes_of("whole"));
}

}  // namespace
}  // namespace craze
