#include "craze/io/image/deflate.h"

#include "craze/error.h"

#ifdef CRAZE_ZLIB
#include <zlib.h>

#include <new>
#endif

namespace craze {

#ifdef CRAZE_ZLIB

namespace {

/// Maps are large and rough: higher levels take several times as long for a few per cent.
constexpr int level = 1;
constexpr int raw_stream = -15, zlib_stream = 15, memory_level = 9;

std::string pack(std::string_view bytes, int window, int flush) {
  z_stream stream{};
  if (deflateInit2(&stream, level, Z_DEFLATED, window, memory_level, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::bad_alloc();
  }
  constexpr std::size_t for_flush = 16;
  std::string packed(deflateBound(&stream, bytes.size()) + for_flush, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, flush);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

const Bytef* data(std::string_view bytes) {
  return reinterpret_cast<const Bytef*>(bytes.data());
}

}  // namespace

bool has_deflate() {
  return true;
}

std::string zlib_pack(std::string_view bytes) {
  return pack(bytes, zlib_stream, Z_FINISH);
}

std::string deflate_part(std::string_view bytes, bool last) {
  return pack(bytes, raw_stream, last ? Z_FINISH : Z_SYNC_FLUSH);
}

std::uint32_t adler(std::string_view bytes) {
  return static_cast<std::uint32_t>(adler32_z(1, data(bytes), bytes.size()));
}

std::uint32_t adler_of_both(std::uint32_t first, std::uint32_t second, std::size_t length) {
  return static_cast<std::uint32_t>(adler32_combine(first, second, static_cast<z_off_t>(length)));
}

#else

namespace {

[[noreturn]] void refuse() {
  throw Error(ErrorKind::request, "cannot write the maps", "zlib", "this build of craze has none");
}

}  // namespace

bool has_deflate() {
  return false;
}
std::string zlib_pack(std::string_view) {
  refuse();
}
std::string deflate_part(std::string_view, bool) {
  refuse();
}
std::uint32_t adler(std::string_view) {
  refuse();
}
std::uint32_t adler_of_both(std::uint32_t, std::uint32_t, std::size_t) {
  refuse();
}

#endif

}  // namespace craze
