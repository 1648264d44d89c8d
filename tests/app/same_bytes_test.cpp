#include <fstream>

#include "app/command.h"
#include "craze/presets.h"

namespace craze {
namespace {

/// Runs the command as on a machine without AVX, FMA and what came after: the C library takes its
/// oldest variants then, which round otherwise.
class OldMachine {
 public:
  OldMachine() { setenv("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX512F,-AVX2,-AVX,-FMA,-FMA4", 1); }
  ~OldMachine() { unsetenv("GLIBC_TUNABLES"); }
};

/// The shapes of the check across builds (scripts/compare_builds.sh).
std::vector<std::string> shapes() {
  std::ifstream file(std::filesystem::path(CRAZE_SOURCE_DIR) / "tests/same_bytes/shapes.txt");
  std::vector<std::string> result;
  for (std::string line; std::getline(file, line);) result.push_back(line);
  return result;
}

class SameBytes : public CommandTest {
 protected:
  std::string everything(const std::string& shape, const std::string& preset) {
    const CommandResult result =
        run({"crack",        shape,        "--preset",  preset,        "-o",       "mesh.ply",
             "--lines",      "lines.json", "--picture", "picture.png", "--width",  "80",
             "--height",     "60",         "--samples", "4",           "--fields", "fields.ply",
             "--max-cracks", "200",        "--quiet"});
    EXPECT_EQ(result.code, 0) << result.err;
    std::string bytes;
    for (const char* name : {"mesh.ply", "lines.json", "picture.png", "fields.ply"}) {
      const std::string text = read_text(file(name));
      EXPECT_FALSE(text.empty()) << name;
      bytes += text;
    }
    return bytes;
  }
};

TEST_F(SameBytes, ComeFromAMachineWithoutWideRegistersAndFusedArithmetic) {
  ASSERT_EQ(shapes().size(), 2u);
  for (const std::string& shape : shapes()) {
    for (const Preset& preset : presets()) {
      const std::string here = everything(shape, std::string(preset.name));
      const OldMachine old;
      EXPECT_TRUE(everything(shape, std::string(preset.name)) == here)
          << preset.name << " on " << shape;
    }
  }
}

}  // namespace
}  // namespace craze
