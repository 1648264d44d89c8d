#include "craze/job/output_folder.h"

#include <unistd.h>

#include <string>
#include <system_error>

#include "craze/error.h"

namespace craze {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const char* what, const fs::path& folder, const std::string& why) {
  throw Error(ErrorKind::output, std::string("cannot write ") + what, folder.string(), why);
}

}  // namespace

void check_output_folder(const char* what, const fs::path& folder) {
  // Folders that are missing are made, in the first that is there.
  std::error_code ignored;
  fs::path there = fs::absolute(folder, ignored);
  while (!fs::exists(there, ignored) && there.has_relative_path()) there = there.parent_path();
  const bool writable = access(there.c_str(), W_OK) == 0;
  if (!fs::is_directory(there, ignored) || !writable) {
    fail(what, folder, there.string() + (writable ? " is no folder" : " cannot be written"));
  }
}

void make_output_folder(const char* what, const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) fail(what, folder, failed.message());
}

}  // namespace craze
