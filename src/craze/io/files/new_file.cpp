#include "craze/io/files/new_file.h"

#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "craze/error.h"

namespace craze {

NewFile::NewFile(const std::filesystem::path& path, const char* what, const Context& context)
    : path_(path), what_(what), context_(context), file_(path) {
  if (file_.descriptor() < 0) require(errno);
}

void NewFile::append(std::string_view bytes) {
  require(write_all(file_.descriptor(), bytes, context_));
  size_ += bytes.size();
}

void NewFile::overwrite(std::uint64_t offset, std::string_view bytes) {
  const auto seek = [this](std::uint64_t to) {
    require(::lseek(file_.descriptor(), static_cast<off_t>(to), SEEK_SET) < 0 ? errno : 0);
  };
  seek(offset);
  require(write_all(file_.descriptor(), bytes, context_));
  seek(size_);
}

void NewFile::finish() {
  require(file_.move_to(path_));
}

void NewFile::require(int code) const {
  if (code == 0) return;
  throw Error(ErrorKind::output, what_, path_.string(), std::generic_category().message(code));
}

}  // namespace craze
