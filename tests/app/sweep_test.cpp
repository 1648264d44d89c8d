#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <thread>
#include <tuple>

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
  /// The files in columns/ and plots/ of two sweeps.
  void expect_same_files(const std::string& a, const std::string& b) const {
    int count = 0;
    for (const char* part : {"columns", "plots"}) {
      for (const auto& entry :
           std::filesystem::recursive_directory_iterator(file(a + "/" + part))) {
        if (!entry.is_regular_file()) continue;
        ++count;
        const auto name = std::filesystem::relative(entry.path(), file(a));
        EXPECT_EQ(read_text(entry.path()), read_text(file(b) / name)) << name;
      }
    }
    EXPECT_GT(count, 100);
  }
  /// The cells of a column of out/table.csv, whose texts have no commas.
  std::vector<std::string> column(const std::string& name) const {
    std::vector<std::string> result;
    std::size_t place = 0;
    for (const std::string& line : lines("out/table.csv")) {
      std::istringstream text(line);
      std::vector<std::string> cells;
      for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
      if (result.empty()) place = std::find(cells.begin(), cells.end(), name) - cells.begin();
      result.push_back(place < cells.size() ? cells[place] : "");
    }
    result.erase(result.begin());
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

TEST_F(Sweep, EveryColumnIsAnArrayOfItsOwn) {
  ASSERT_EQ(run({"sweep", "plan.toml", "-o", "out"}).code, 0);
  for (const char* name : {"row", "recipe.material.alpha", "length", "angles.t.error"}) {
    const std::string bytes = read_text(file("out/columns") / (std::string(name) + ".npy"));
    ASSERT_GT(bytes.size(), 128u) << name;
    EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t head = 10 + static_cast<unsigned char>(bytes[8]);
    EXPECT_EQ(head % 64, 0u);
    EXPECT_NE(bytes.find("'<f8', 'fortran_order': False, 'shape': (6,)"), std::string::npos);
    ASSERT_EQ(bytes.size(), head + 6 * 8);
    const auto cells = column(name);
    ASSERT_EQ(cells.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
      double value = 0;
      std::memcpy(&value, bytes.data() + head + 8 * i, 8);
      if (cells[i].empty()) {
        EXPECT_TRUE(std::isnan(value)) << name;
      } else {
        EXPECT_EQ(value, std::stod(cells[i])) << name;
      }
    }
  }
}

TEST_F(Sweep, APlotOfEachStatisticHasItsMeansAndErrorsOverTheKey) {
  ASSERT_EQ(run({"sweep", "plan.toml", "-o", "out"}).code, 0);
  const auto values = column("length_per_area");
  const std::string plot =
      read_text(file("out/plots/recipe.layer.relative_spacing/length_per_area.svg"));
  EXPECT_EQ(plot.rfind("<svg", 0), 0u);
  for (const std::size_t first : {0, 3}) {
    double mean = 0, squares = 0;
    for (std::size_t i = first; i < first + 3; ++i) mean += std::stod(values[i]) / 3;
    for (std::size_t i = first; i < first + 3; ++i) {
      squares += (std::stod(values[i]) - mean) * (std::stod(values[i]) - mean);
    }
    char title[100];
    std::snprintf(title, sizeof title, "<title>%s: %.6g ± %.2g (3 runs)</title>",
                  first == 0 ? "0.2" : "0.3", mean, std::sqrt(squares / 2 / 3));
    EXPECT_NE(plot.find(title), std::string::npos) << title << "\n" << plot;
  }
  // What is drawn has plots too, over intervals of its range.
  const std::string drawn = read_text(file("out/plots/recipe.material.alpha/length_per_area.svg"));
  EXPECT_NE(drawn.find("(3 runs)</title>"), std::string::npos) << drawn;
}

TEST_F(Sweep, AnyShardsAndThreadsGiveTheSameBytes) {
  ASSERT_EQ(run({"sweep", "plan.toml", "-o", "one", "--threads", "1"}).code, 0);
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    EXPECT_FALSE(std::filesystem::exists(file("three/table.csv")));
    ASSERT_EQ(run({"sweep", "plan.toml", "-o", "three", "--threads", "2", "--shard", shard}).code,
              0);
  }
  EXPECT_EQ(read_text(file("one/table.csv")), read_text(file("three/table.csv")));
  expect_same_files("one", "three");
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
  expect_same_files("whole", "cut");
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
  const CommandResult done = run({"sweep", "bad.toml", "-o", "bad", "--quiet"});
  ASSERT_EQ(done.code, 0);
  EXPECT_EQ(done.err.rfind("craze: warning: 1 of 2 rows could not be done (status in table.csv), "
                           "first row 1: cannot read mesh (",
                           0),
            0u)
      << done.err;
  const auto table = lines("bad/table.csv");
  EXPECT_NE(table[1].find(",ok,"), std::string::npos);
  EXPECT_NE(table[2].find("none.obj"), std::string::npos);
  EXPECT_NE(table[2].find("cannot read mesh"), std::string::npos);
  // The part that the warning names is run again, and the mesh is there by now.
  std::ofstream(file("none.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_NE(done.err.find("first bad/parts/000000.csv\n"), std::string::npos) << done.err;
  std::filesystem::remove(file("bad/parts/000000.csv"));
  EXPECT_EQ(run({"sweep", "bad.toml", "-o", "bad"}).err, "");
  EXPECT_NE(lines("bad/table.csv")[2].find(",ok,"), std::string::npos);
}

TEST_F(Sweep, OneFolderHoldsOnePlan) {
  ASSERT_EQ(run({"sweep", "plan.toml", "-o", "out"}).code, 0);
  std::ofstream(file("plan.toml"), std::ios::app) << "# another\n";
  const CommandResult result = run({"sweep", "plan.toml", "-o", "out"});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("holds another plan"), std::string::npos) << result.err;
}

TEST_F(Sweep, MoreDrawsGoOnWhereFewerEnded) {
  const auto plan = [&](int draws, int repeats) {
    std::ofstream(file("plan.toml")) << "draws = " << draws << "\nrepeats = " << repeats
                                     << "\npart_rows = 4\n"
                                        "object = \"shape:plate?n=14&jitter=0.3\"\n"
                                        "[recipe]\npreset = \"mud\"\n"
                                        "material.alpha = {uniform = [0.1, 0.9]}\n";
  };
  plan(6, 2);
  ASSERT_EQ(run({"sweep", "plan.toml", "-o", "at_once"}).code, 0);
  plan(3, 2);
  ASSERT_EQ(run({"sweep", "plan.toml", "-o", "out"}).code, 0);
  const std::string small = read_text(file("out/table.csv"));
  plan(6, 2);
  for (int attempt = 0; attempt < 8; ++attempt) {
    const pid_t process = start({"sweep", "plan.toml", "-o", "out", "--threads", "1"});
    std::this_thread::sleep_for(std::chrono::milliseconds(3 + 11 * attempt));
    kill(process, SIGKILL);
    finish(process);
    // Where it is, it is the one of before or the whole one, and columns have its rows.
    const std::string table = read_text(file("out/table.csv"));
    const bool whole = table == read_text(file("at_once/table.csv"));
    EXPECT_TRUE(table.empty() || table == small || whole);
    if (!table.empty()) {
      EXPECT_NE(read_text(file("out/columns/row.npy")).find(whole ? "(12,)" : "(6,)"),
                std::string::npos);
    }
  }
  ASSERT_EQ(run({"sweep", "plan.toml", "-o", "out", "--shard", "1/2"}).code, 0);
  ASSERT_EQ(run({"sweep", "plan.toml", "-o", "out", "--shard", "2/2"}).code, 0);
  for (const char* name : {"table.csv", "plan.toml", "made_by.json", "parts/000001.csv"}) {
    EXPECT_EQ(read_text(file("out") / name), read_text(file("at_once") / name)) << name;
  }
  expect_same_files("out", "at_once");
  const std::string table = read_text(file("out/table.csv"));
  for (const auto& [draws, repeats, words] :
       {std::tuple(5, 2, "12 rows there, 10 asked for"), {6, 3, "come behind those there are"}}) {
    plan(draws, repeats);
    const CommandResult refused = run({"sweep", "plan.toml", "-o", "out"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find(words), std::string::npos) << refused.err;
    EXPECT_EQ(refused.err.find('\n'), refused.err.size() - 1) << refused.err;
    EXPECT_EQ(read_text(file("out/table.csv")), table);
  }
  plan(7, 2);
  EXPECT_EQ(run({"sweep", "plan.toml", "-o", "out"}).err,
            "craze: note: the table goes on from 12 rows to 14\n");
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
