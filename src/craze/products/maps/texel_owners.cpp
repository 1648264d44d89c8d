#include "craze/products/maps/texel_owners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace craze {

namespace {

constexpr std::uint16_t no_row = 0xffff;

/// Where the edge from a to b crosses the line through the centres of a row; the same bits from
/// both sides.
double crossing(Vec2 a, Vec2 b, double y) {
  if (std::pair(b.y(), b.x()) < std::pair(a.y(), a.x())) std::swap(a, b);
  return a.x() + (y - a.y()) * ((b.x() - a.x()) / (b.y() - a.y()));
}

/// The first texel, from 0 to `size`, whose centre is at x or right of it.
int first_from(double x, int size) {
  return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(size)));
}

/// Calls visit(y, begin, end) for the rows of texels whose centres lie in the triangle.
template <class Visit>
void for_each_span(const std::array<Vec2, 3>& t, int size, Visit&& visit) {
  const double low = std::min({t[0].y(), t[1].y(), t[2].y()});
  const double high = std::max({t[0].y(), t[1].y(), t[2].y()});
  const int end = first_from(high, size);
  for (int y = first_from(low, size); y < end; ++y) {
    const double middle = y + 0.5;
    double left = INFINITY, right = -INFINITY;
    for (int i = 0; i < 3; ++i) {
      const Vec2 &a = t[i], &b = t[(i + 1) % 3];
      if ((a.y() <= middle) == (b.y() <= middle)) continue;
      const double x = crossing(a, b, middle);
      left = std::min(left, x);
      right = std::max(right, x);
    }
    if (left < right) visit(y, first_from(left, size), first_from(right, size));
  }
}

}  // namespace

TexelOwners::TexelOwners(std::span<const MapPiece> pieces, std::span<const PlacedPiece> placed,
                         int size)
    : size_(size), owner_(static_cast<std::size_t>(size) * size, -1) {
  std::vector<std::int32_t> without;
  const auto corners = [&](std::int32_t i) {
    const std::array<Vec2, 3>& uvs = pieces[placed[i].piece].uvs;
    return std::array<Vec2, 3>{in_texels(uvs[0], placed[i].offset, size),
                               in_texels(uvs[1], placed[i].offset, size),
                               in_texels(uvs[2], placed[i].offset, size)};
  };
  for (std::size_t p = 0; p < placed.size(); ++p) {
    const auto i = static_cast<std::int32_t>(p);
    bool any = false;
    for_each_span(corners(i), size, [&](int y, int begin, int end) {
      std::int32_t* row = owner_.data() + static_cast<std::size_t>(y) * size_;
      for (int x = begin; x < end; ++x) {
        if (row[x] < 0) {
          row[x] = i;
          ++covered_;
        } else {
          ++overlapping_;
        }
        any = true;
      }
    });
    if (!any) without.push_back(i);
  }
  for (const std::int32_t i : without) {
    const auto t = corners(i);
    const Vec2 middle = (t[0] + t[1] + t[2]) / 3;
    const double x = std::floor(middle.x()), y = std::floor(middle.y());
    if (!(x >= 0 && y >= 0 && x < size && y < size)) continue;
    std::int32_t& owner = owner_[static_cast<std::size_t>(y) * size_ + static_cast<std::size_t>(x)];
    if (owner >= 0) continue;
    owner = i;
    ++covered_;
  }
  find_nearest_in_columns();
}

void TexelOwners::find_nearest_in_columns() {
  nearest_row_.assign(owner_.size(), no_row);
  const auto n = static_cast<std::size_t>(size_);
  for (std::size_t y = 0; y < n; ++y) {
    for (std::size_t i = y * n; i < (y + 1) * n; ++i) {
      nearest_row_[i] = owner_[i] >= 0 ? static_cast<std::uint16_t>(y)
                        : y > 0        ? nearest_row_[i - n]
                                       : no_row;
    }
  }
  for (std::size_t y = n - 1; y-- > 0;) {
    for (std::size_t i = y * n; i < (y + 1) * n; ++i) {
      const std::uint16_t below = nearest_row_[i + n];
      const std::uint16_t above = nearest_row_[i];
      if (below != no_row && (above == no_row || below - y < y - above)) nearest_row_[i] = below;
    }
  }
}

// The second half of the exact distance transform of Meijster, Roerdink and Hesselink, A general
// algorithm for computing distance transforms in linear time, 2000: the lower envelope of the
// parabolas (x − i)² + g(i)².
void TexelOwners::row(int y, std::vector<Owner>& owners) const {
  owners.assign(static_cast<std::size_t>(size_), Owner{-1, 0, 0});
  const std::uint16_t* nearest = nearest_row_.data() + static_cast<std::size_t>(y) * size_;
  std::vector<int> columns, starts;  // of the envelope: whose it is, and from which texel on
  const auto height = [&](int i) {
    const std::int64_t g = nearest[i] - y;
    return g * g;
  };
  for (int i = 0; i < size_; ++i) {
    if (nearest[i] == no_row) continue;
    int start = 0;
    while (!columns.empty()) {
      // Where column i is nearer for the first time than the envelope's last.
      const std::int64_t j = columns.back();
      const std::int64_t above =
          height(i) - height(static_cast<int>(j)) + i * std::int64_t{i} - j * j;
      const std::int64_t twice = 2 * (i - j);
      const std::int64_t floor = above >= 0 ? above / twice : -((-above + twice - 1) / twice);
      start = static_cast<int>(std::clamp<std::int64_t>(floor + 1, 0, size_));
      if (start > starts.back()) break;
      columns.pop_back();
      starts.pop_back();
      start = 0;
    }
    if (start >= size_) continue;
    columns.push_back(i);
    starts.push_back(start);
  }
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const int end = k + 1 < columns.size() ? starts[k + 1] : size_;
    const int x = columns[k], row = nearest[x];
    const std::int32_t owner = owner_[static_cast<std::size_t>(row) * size_ + x];
    for (int i = starts[k]; i < end; ++i) owners[i] = {owner, x, row};
  }
}

}  // namespace craze
