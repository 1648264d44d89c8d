// Format: 3D Systems, "StereoLithography Interface Specification", 1988.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

#include "craze/base/random.h"
#include "craze/io/bytes/byte_order.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/bytes/text_cursor.h"
#include "craze/io/polygons/polygon_soup.h"
#include "craze/io/stl/stl.h"

namespace craze {

namespace {

constexpr std::size_t header_size = 84, triangle_size = 50;

std::vector<Vec3> read_binary(std::string_view bytes, const std::string& name) {
  const std::size_t triangles = load<std::uint32_t>(bytes.data() + 80);
  const std::size_t held = (bytes.size() - header_size) / triangle_size;
  if (triangles > held) {
    fail_input(name, fmt::format("it promises {} triangles but holds {}", triangles, held));
  }
  std::vector<Vec3> corners;
  corners.reserve(3 * triangles);
  for (std::size_t f = 0; f < triangles; ++f) {
    const char* p = bytes.data() + header_size + triangle_size * f + 12;  // after the normal
    for (int i = 0; i < 3; ++i, p += 12) {
      corners.emplace_back(load<float>(p), load<float>(p + 4), load<float>(p + 8));
      if (!corners.back().allFinite()) {
        fail_input(name, fmt::format("triangle {} has a coordinate that is not finite", f));
      }
    }
  }
  return corners;
}

bool equal_ignoring_case(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

std::vector<Vec3> read_ascii(std::string_view bytes, const std::string& name) {
  TextCursor text(bytes, name);
  std::vector<Vec3> corners;
  std::size_t in_loop = 0;
  while (text.skip_blank()) {
    const std::string_view word = text.word();
    if (equal_ignoring_case(word, "vertex")) {
      const double x = text.number("a coordinate"), y = text.number("a coordinate");
      corners.emplace_back(x, y, text.number("a coordinate"));
      ++in_loop;
    } else if (equal_ignoring_case(word, "endloop")) {
      if (in_loop != 3) text.fail(fmt::format("a loop has {} vertices, not 3", in_loop));
      in_loop = 0;
    } else if (equal_ignoring_case(word, "solid") || equal_ignoring_case(word, "endsolid") ||
               equal_ignoring_case(word, "facet")) {
      text.skip_line();  // names and normals
    } else if (!equal_ignoring_case(word, "outer") && !equal_ignoring_case(word, "loop") &&
               !equal_ignoring_case(word, "endfacet")) {
      text.fail(fmt::format("'{}' is not a word of STL", printable(word)));
    }
  }
  if (in_loop != 0) text.fail("the file ends within a facet");
  return corners;
}

std::size_t hash_place(const Vec3& p) {
  std::uint64_t hash = 0;
  for (const double x : p)
    hash = hash_bits(hash ^ std::bit_cast<std::uint64_t>(x + 0.0));  // −0 is 0
  return hash;
}

/// The corners in an order that puts those at the same place together, rising among themselves:
/// scattered into buckets by hash, then sorted within each. No choice of places makes it slow.
std::vector<std::int32_t> gather_places(const std::vector<Vec3>& corners) {
  const std::size_t buckets = std::bit_ceil(corners.size() + 1);
  std::vector<std::size_t> begin(buckets + 1, 0);
  std::vector<std::uint32_t> bucket;
  bucket.reserve(corners.size());
  for (const Vec3& p : corners) {
    bucket.push_back(static_cast<std::uint32_t>(hash_place(p) & (buckets - 1)));
    ++begin[bucket.back() + 1];
  }
  for (std::size_t b = 0; b < buckets; ++b) begin[b + 1] += begin[b];
  std::vector<std::int32_t> order(corners.size());
  std::vector<std::size_t> at = begin;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    order[at[bucket[c]]++] = static_cast<std::int32_t>(c);
  }
  const auto less = [&](std::int32_t a, std::int32_t b) {
    const Vec3 &p = corners[a], &q = corners[b];
    return std::tie(p.x(), p.y(), p.z(), a) < std::tie(q.x(), q.y(), q.z(), b);
  };
  for (std::size_t b = 0; b < buckets; ++b) {
    std::sort(order.data() + begin[b], order.data() + begin[b + 1], less);
  }
  return order;
}

/// Makes one vertex of corners at the same place.
void weld(const std::vector<Vec3>& corners, SurfaceMesh& mesh) {
  const std::vector<std::int32_t> order = gather_places(corners);
  // Each corner's leader is the first one at its place.
  std::vector<std::int32_t> leader(corners.size()), vertex(corners.size());
  std::int32_t first = order.empty() ? 0 : order[0];
  for (const std::int32_t c : order) {
    if (corners[c] != corners[first]) first = c;
    leader[c] = first;
  }
  mesh.triangles.resize(corners.size() / 3);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (leader[c] == static_cast<std::int32_t>(c)) {
      vertex[c] = static_cast<std::int32_t>(mesh.positions.size());
      mesh.positions.push_back(corners[c]);
    }
    mesh.triangles[c / 3][c % 3] = vertex[leader[c]];
  }
}

bool starts_with_solid(std::string_view bytes) {
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  return start != std::string::npos && equal_ignoring_case(bytes.substr(start, 5), "solid");
}

}  // namespace

SurfaceMesh read_stl(std::string_view bytes, const std::string& name) {
  const bool fits_binary =
      bytes.size() >= header_size &&
      bytes.size() == header_size + triangle_size * load<std::uint32_t>(bytes.data() + 80);
  const bool is_ascii = !fits_binary && starts_with_solid(bytes);
  if (!is_ascii && bytes.size() < header_size) {
    fail_input(name, "it is neither ascii STL (no 'solid') nor long enough for binary STL");
  }
  const std::vector<Vec3> corners = is_ascii ? read_ascii(bytes, name) : read_binary(bytes, name);
  if (corners.size() > 2147483647) fail_input(name, "it has more than 2^31 - 1 corners");
  SurfaceMesh mesh;
  weld(corners, mesh);
  mesh.source_faces.resize(mesh.triangles.size());
  std::iota(mesh.source_faces.begin(), mesh.source_faces.end(), 0);
  check_size(mesh, name);
  return mesh;
}

}  // namespace craze
