// The pictures that a recipe names.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/grey_image.h"
#include "craze/recipe.h"

namespace craze {

/// A picture that a recipe names.
struct NamedTexture {
  std::string key;   ///< "where.texture"
  std::string name;  ///< as the recipe has it
};

/// All of them, in the order of the parameters.
std::vector<NamedTexture> named_textures(const Recipe& recipe);

/// Where a file's pictures are sought: beside it first, then from the working folder.
struct TextureFolder {
  std::filesystem::path folder;  ///< of the recipe's or plan's file
  std::set<std::string> names;   ///< that it gives; others are sought in the working folder alone
};

/// That of a file in `folder` which gives all that `recipe` names.
TextureFolder texture_folder(const std::filesystem::path& folder, const Recipe& recipe);

/// The file that is meant. Throws Error(input) where there is none, with the places it was sought.
std::filesystem::path find_texture(const NamedTexture& texture, const TextureFolder& beside);

/// Each once, by the name that the recipe gives. Throws Error(input) and Cancelled.
Textures load_textures(const Recipe& recipe, const TextureFolder& beside, const Context& context);

}  // namespace craze
