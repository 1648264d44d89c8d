#include "craze/io/files/tar.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <numeric>

#include "craze/base/text/format.h"
#include "craze/error.h"

namespace craze {

namespace {

constexpr std::size_t block = 512;
constexpr std::uint64_t largest = std::uint64_t{1} << 33;  // what its field can say

using Header = std::array<char, block>;

void put(Header& header, std::size_t at, std::string_view text) {
  std::copy(text.begin(), text.end(), header.begin() + static_cast<std::ptrdiff_t>(at));
}

/// The sum of the header's bytes, those of the sum itself as spaces.
unsigned sum_of(const Header& header) {
  unsigned sum = 8 * ' ';
  for (std::size_t i = 0; i < block; ++i) {
    if (i < 148 || i >= 156) sum += static_cast<unsigned char>(header[i]);
  }
  return sum;
}

std::uint64_t octal(const Header& header, std::size_t at, std::size_t length) {
  std::uint64_t value = 0;
  std::from_chars(header.data() + at, header.data() + at + length, value, 8);
  return value;
}

std::size_t padding(std::size_t size) {
  return (block - size % block) % block;
}

}  // namespace

std::string tar_entry(std::string_view name, std::string_view bytes) {
  Header header{};
  put(header, 0, name.substr(0, 100));
  put(header, 100, "0000644");
  put(header, 108, "0000000");
  put(header, 116, "0000000");
  put(header, 124, fmt::format("{:011o}", bytes.size()));
  put(header, 136, "00000000000");
  header[156] = '0';
  put(header, 257, std::string_view("ustar\00000", 8));
  put(header, 148, fmt::format("{:06o}", sum_of(header)));
  header[155] = ' ';
  std::string entry(header.data(), block);
  entry += bytes;
  entry.append(padding(bytes.size()), '\0');
  return entry;
}

std::string tar_end() {
  return std::string(2 * block, '\0');
}

TarReader::TarReader(const std::filesystem::path& path)
    : path_(path), file_(path, std::ios::binary) {
  if (!file_) fail("no such file, or not readable");
}

bool TarReader::next(std::string& name, std::string& bytes) {
  Header header;
  if (!file_.read(header.data(), block)) fail("it ends too soon");
  if (std::all_of(header.begin(), header.end(), [](char c) { return c == 0; })) return false;
  const std::uint64_t size = octal(header, 124, 12);
  if (octal(header, 148, 7) != sum_of(header) || size >= largest) fail("it is no archive");
  name.assign(header.data(), std::find(header.begin(), header.begin() + 100, '\0'));
  bytes.clear();
  // A part at a time, so that a false size does not take the memory.
  constexpr std::uint64_t part = std::uint64_t{1} << 20;
  for (std::uint64_t left = size + padding(size); left > 0;) {
    const std::uint64_t now = std::min(left, part);
    const std::size_t held = bytes.size();
    bytes.resize(held + now);
    if (!file_.read(bytes.data() + held, static_cast<std::streamsize>(now))) {
      fail("it ends too soon");
    }
    left -= now;
  }
  bytes.resize(size);
  return true;
}

void TarReader::fail(const char* why) const {
  throw Error(ErrorKind::input, "cannot read archive", path_.string(), why);
}

}  // namespace craze
