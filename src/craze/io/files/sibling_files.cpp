#include "craze/io/files/sibling_files.h"

#include <system_error>

#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/files/read_file.h"

namespace craze {

namespace {

namespace fs = std::filesystem;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// Whether `..` leads above where the path begins.
bool leads_above(const fs::path& path) {
  const fs::path whole = path.lexically_normal();
  return !whole.empty() && *whole.begin() == "..";
}

/// True if every part of `folder` begins `path`; both are canonical.
bool is_inside(const fs::path& path, const fs::path& folder) {
  auto p = path.begin();
  for (const fs::path& part : folder) {
    if (part.empty()) continue;
    if (p == path.end() || *p != part) return false;
    ++p;
  }
  return true;
}

}  // namespace

std::string decode_percent(const std::string& uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool escaped = uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 &&
                         hex_digit(uri[i + 2]) >= 0;
    if (escaped) {
      text += static_cast<char>(16 * hex_digit(uri[i + 1]) + hex_digit(uri[i + 2]));
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

FileLoader load_from_folder(const fs::path& folder, const Context& context) {
  return [folder, &context](const std::string& uri) {
    const auto refuse = [&](const char* why) {
      fail_input(folder.string(), fmt::format("buffer file '{}' {}", printable(uri), why));
    };
    const auto check_plain = [&](const std::string& text) {
      // A colon makes a scheme (file:, http:) or a drive, a backslash another system's path.
      if (text.find_first_of(std::string(":\\\0", 3)) != std::string::npos ||
          fs::path(text).is_absolute()) {
        refuse("is not a plain path inside the model's folder");
      }
      if (leads_above(text)) {
        refuse(
            "is not inside the model's folder; for safety no other file is opened, so move it "
            "there");
      }
    };
    const std::string text = decode_percent(uri);
    check_plain(text);
    std::error_code broken;
    const fs::path root = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, broken);
    fs::path path = broken ? fs::path() : fs::weakly_canonical(root / text, broken);
    if (broken) refuse("cannot be found");
    // Some files are really called so.
    if (text != uri && !fs::exists(path, broken)) {
      check_plain(uri);
      const fs::path literal = fs::weakly_canonical(root / uri, broken);
      if (!broken && fs::exists(literal, broken)) path = literal;
    }
    if (!is_inside(path, root)) refuse("is a link that leads out of the model's folder");
    if (fs::exists(path, broken) && !fs::is_regular_file(path, broken)) refuse("is not a file");
    return read_file(path, "cannot read mesh", context);
  };
}

}  // namespace craze
