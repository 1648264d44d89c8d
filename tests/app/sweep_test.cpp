#include <chrono>
#include <thread>

#include "app/command.h"

namespace craze {
namespace {

class Sweep : public CommandTest {
 protected:
  Sweep() {
    std::ofstream(file("plan.toml")) << "repeats = 3\npart_rows = 2\n"
                                        "object = \"shape:plate?n=14&jitter=0.3\"\n"
                                        "[recipe]\npreset = \"mud\"\n"
                                        "[recipe.layer]\nrelative_spacing = {values = [0.2, 0.3]}\n"
                                        "[recipe.material]\nalpha = {uniform = [0.1, 0.9]}\n";
  }
  std::vector<std::string> lines(const std::string& name) const {
    std::vector<std::string> result;
    std::istringstream text(read_text(file(name)));
    for (std::string line; std::getline(text, line);) result.push_back(line);
    return result;
  }
};

TEST_F(Sweep, EveryPointOfTheGridComesWithEverySeed) {
  const CommandResult result = run({"sweep", "plan.toml", "-o", "out"});
  ASSERT_EQ(result.code, 0) << result.err;
  const auto table = lines("out/table.csv");
  ASSERT_EQ(table.size(), 7u);
  const std::string head = "row,seed,recipe.layer.relative_spacing,recipe.material.alpha,status,";
  EXPECT_EQ(table[0].substr(0, head.size()), head);
  EXPECT_EQ(table[1].substr(0, 8), "0,1,0.2,");
  EXPECT_EQ(table[3].substr(0, 8), "2,3,0.2,");
  EXPECT_EQ(table[4].substr(0, 8), "3,1,0.3,");
  for (std::size_t i = 1; i < table.size(); ++i) {
    EXPECT_NE(table[i].find(",ok,"), std::string::npos) << table[i];
  }
  // What is drawn is the same for all seeds of a point.
  EXPECT_EQ(table[1].substr(8, 8), table[2].substr(8, 8));
}

TEST_F(Sweep, AnyShardsAndThreadsGiveTheSameBytes) {
  ASSERT_EQ(run({"sweep", "plan.toml", "-o", "one", "--threads", "1"}).code, 0);
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    EXPECT_FALSE(std::filesystem::exists(file("three/table.csv")));
    ASSERT_EQ(run({"sweep", "plan.toml", "-o", "three", "--threads", "2", "--shard", shard}).code,
              0);
  }
  EXPECT_EQ(read_text(file("one/table.csv")), read_text(file("three/table.csv")));
  EXPECT_EQ(read_text(file("one/table.npy")), read_text(file("three/table.npy")));
}

TEST_F(Sweep, KilledAtAnyMomentItGoesOnToTheSameBytes) {
  ASSERT_EQ(run({"sweep", "plan.toml", "-o", "whole"}).code, 0);
  int killed = 0;
  for (int attempt = 0; attempt < 8; ++attempt) {
    const std::string shard = std::to_string(attempt % 2) + "/2";
    const pid_t process = start({"sweep", "plan.toml", "-o", "cut", "--shard", shard});
    std::this_thread::sleep_for(std::chrono::milliseconds(5 + 17 * attempt));
    kill(process, SIGKILL);
    killed += finish(process).code == 128 + SIGKILL;
  }
  EXPECT_GT(killed, 0);
  for (const char* shard : {"0/3", "1/3", "2/3"}) {
    ASSERT_EQ(run({"sweep", "plan.toml", "-o", "cut", "--shard", shard}).code, 0);
  }
  EXPECT_EQ(read_text(file("whole/table.csv")), read_text(file("cut/table.csv")));
  EXPECT_EQ(read_text(file("whole/table.npy")), read_text(file("cut/table.npy")));
}

TEST_F(Sweep, ATornPartIsMadeAgain) {
  ASSERT_EQ(run({"sweep", "plan.toml", "-o", "out"}).code, 0);
  const std::string table = read_text(file("out/table.csv"));
  const std::string part = read_text(file("out/parts/000001.csv"));
  std::ofstream(file("out/parts/000001.csv")) << part.substr(0, part.size() / 2);
  std::filesystem::remove(file("out/table.csv"));
  const CommandResult again = run({"sweep", "plan.toml", "-o", "out"});
  EXPECT_NE(again.out.find("1 made now"), std::string::npos) << again.out;
  EXPECT_EQ(read_text(file("out/table.csv")), table);
}

TEST_F(Sweep, ARunThatCannotBeDoneSaysSoInItsRow) {
  std::ofstream(file("bad.toml")) << "object = {values = [\"shape:plate?n=8\", \"none.obj\"]}\n";
  ASSERT_EQ(run({"sweep", "bad.toml", "-o", "bad"}).code, 0);
  const auto table = lines("bad/table.csv");
  EXPECT_NE(table[1].find(",ok,"), std::string::npos);
  EXPECT_NE(table[2].find("none.obj"), std::string::npos);
  EXPECT_NE(table[2].find("cannot read mesh"), std::string::npos);
}

TEST_F(Sweep, OneFolderHoldsOnePlan) {
  ASSERT_EQ(run({"sweep", "plan.toml", "-o", "out"}).code, 0);
  std::ofstream(file("plan.toml"), std::ios::app) << "# another\n";
  const CommandResult result = run({"sweep", "plan.toml", "-o", "out"});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("holds another plan"), std::string::npos) << result.err;
}

TEST_F(Sweep, WrongShardsAreRefused) {
  for (const char* shard : {"", "1", "1/0", "3/2", "-1/2", "1/2/3", "a/b"}) {
    const CommandResult result = run({"sweep", "plan.toml", "-o", "out", "--shard", shard});
    EXPECT_EQ(result.code, 2) << shard;
    EXPECT_NE(result.err.find("shard"), std::string::npos) << result.err;
  }
}

}  // namespace
}  // namespace craze
