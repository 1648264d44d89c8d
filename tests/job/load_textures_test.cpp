#include "craze/job/load_textures.h"

#include <gtest/gtest.h>

#include <fstream>

#include "craze/error.h"
#include "craze/job/dataset/dataset.h"
#include "craze/render/png.h"
#include "temporary_folder.h"

namespace craze {
namespace {

namespace fs = std::filesystem;

/// A picture of one grey.
void write_grey(const fs::path& path, std::uint8_t grey) {
  render::write_png(path.string(), {1, 1, {grey, grey, grey}}, {});
}

/// The working folder while it lasts.
class InFolder {
 public:
  explicit InFolder(const fs::path& folder) : before_(fs::current_path()) {
    fs::current_path(folder);
  }
  InFolder(const InFolder&) = delete;
  InFolder& operator=(const InFolder&) = delete;
  ~InFolder() { fs::current_path(before_); }

 private:
  fs::path before_;
};

Recipe masked(const std::string& name) {
  Recipe recipe;
  recipe.simulation.where.texture = name;
  return recipe;
}

float grey_of(const Textures& textures, const std::string& name) {
  return textures.at(name).pixels.at(0);
}

TEST(LoadTextures, SeeksBesideTheRecipeFirst) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "recipes/paint");
  fs::create_directories(folder / "work");
  const InFolder work(folder / "work");
  const TextureFolder beside = texture_folder(folder / "recipes", masked("paint/a.png"));
  write_grey(folder / "recipes/paint/a.png", 255);
  const Textures near = load_textures(masked("paint/a.png"), beside, {});
  EXPECT_EQ(grey_of(near, "paint/a.png"), 1);

  fs::create_directories(folder / "work/paint");
  write_grey(folder / "work/paint/a.png", 0);
  EXPECT_EQ(grey_of(load_textures(masked("paint/a.png"), beside, {}), "paint/a.png"), 1);
  fs::remove(folder / "recipes/paint/a.png");
  EXPECT_EQ(grey_of(load_textures(masked("paint/a.png"), beside, {}), "paint/a.png"), 0);
  // What another says than the recipe's file is seen from the working folder alone.
  write_grey(folder / "recipes/b.png", 255);
  write_grey(folder / "work/b.png", 0);
  EXPECT_EQ(grey_of(load_textures(masked("b.png"), beside, {}), "b.png"), 0);
}

TEST(LoadTextures, SaysWhereItSought) {
  const TemporaryFolder folder;
  const TextureFolder beside = texture_folder(folder.path(), masked("none.png"));
  try {
    load_textures(masked("none.png"), beside, {});
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.what(), "no picture none.png (where.texture): it is neither " +
                            (folder / "none.png").string() + " nor in the working folder");
  }
}

TEST(LoadTextures, OfSetsAreMissedBeforeAnyWork) {
  const TemporaryFolder folder;
  const PlanSource plan{"samples = 1\n[recipe]\nwhere.texture = {choice = [\"\", \"none.png\"]}\n",
                        "plan.toml", folder.path()};
  try {
    make_dataset(plan, folder / "set", {}, {});
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("no picture none.png (where.texture)"), std::string::npos)
        << e.what();
    EXPECT_FALSE(fs::exists(folder / "set"));
  }
}

}  // namespace
}  // namespace craze
