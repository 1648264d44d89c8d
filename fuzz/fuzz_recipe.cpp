// Any text is a recipe that reads back equal, or one Error; so is any setting.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "craze/error.h"
#include "craze/recipe.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const craze::Recipe recipe = craze::read_recipe(text, "fuzz");
    if (!(craze::read_recipe(craze::write_recipe(recipe), "again") == recipe)) std::abort();
  } catch (const craze::Error&) {
  }
  try {
    craze::Recipe recipe;
    craze::apply_set(recipe, text);
    if (!(craze::read_recipe(craze::write_recipe(recipe), "again") == recipe)) std::abort();
  } catch (const craze::Error&) {
  }
  return 0;
}
