// Where the page of the studio lies: beside the program, installed or built.
#pragma once

#include <filesystem>

namespace craze::app {

/// The folder with index.html in it, found from where this very program is. Throws Error(request)
/// where there is none.
std::filesystem::path page_folder();

}  // namespace craze::app
