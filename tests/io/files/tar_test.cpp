#include "craze/io/files/tar.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "craze/error.h"
#include "temporary_folder.h"

namespace craze {
namespace {

std::map<std::string, std::string> files() {
  return {{"000000001.json", "{}"},
          {"000000001.mask.png", std::string(512, '\0')},
          {"empty", ""},
          {"long", std::string(1500, 'x')}};
}

void write(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string archive() {
  std::string bytes;
  for (const auto& [name, content] : files()) bytes += tar_entry(name, content);
  return bytes + tar_end();
}

TEST(Tar, HoldsWhatWasPutIn) {
  const TemporaryFolder folder;
  write(folder / "a.tar", archive());
  TarReader tar(folder / "a.tar");
  std::map<std::string, std::string> read;
  std::string name, bytes;
  while (tar.next(name, bytes)) read[name] = bytes;
  EXPECT_EQ(read, files());
}

TEST(Tar, IsReadByOthers) {
  const TemporaryFolder folder;
  write(folder / "a.tar", archive());
  const std::string at = folder.path().string();
  ASSERT_EQ(std::system(("tar -xf " + at + "/a.tar -C " + at).c_str()), 0);
  for (const auto& [name, content] : files()) {
    EXPECT_EQ(std::filesystem::file_size(folder / name), content.size()) << name;
  }
}

TEST(Tar, TornAndForeignArchivesAreRefused) {
  const TemporaryFolder folder;
  const std::string whole = archive();
  for (const std::size_t size : {0u, 100u, 512u, 700u, 1600u}) {
    write(folder / "a.tar", whole.substr(0, size));
    TarReader tar(folder / "a.tar");
    std::string name, bytes;
    EXPECT_THROW(while (tar.next(name, bytes)){}, Error) << size;
  }
  write(folder / "a.tar", std::string(2048, 'x'));
  TarReader tar(folder / "a.tar");
  std::string name, bytes;
  EXPECT_THROW(tar.next(name, bytes), Error);
  EXPECT_THROW(TarReader(folder / "none.tar"), Error);
}

}  // namespace
}  // namespace craze
