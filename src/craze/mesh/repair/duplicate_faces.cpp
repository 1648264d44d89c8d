#include "craze/mesh/repair/duplicate_faces.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace craze {

namespace {

// A face by its corners alone: sorted, and whether sorting took an odd permutation.
struct Named {
  Triangle corners;
  bool odd;
  std::int32_t face;
};

Named name_of(const Triangle& t, std::int32_t face) {
  Named n{t, false, face};
  const auto order = [&](int i, int j) {
    if (n.corners[i] > n.corners[j]) {
      std::swap(n.corners[i], n.corners[j]);
      n.odd = !n.odd;
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return n;
}

// What is left of each set of equal faces: one, and where it has two sides also the other side.
struct Kept {
  Triangle corners;
  std::int32_t face, other_side;
  bool two_sided;
};

struct Side {
  std::int32_t low, high, kept;
};

std::vector<Kept> one_of_each(std::vector<Named> named) {
  std::sort(named.begin(), named.end(), [](const Named& a, const Named& b) {
    return std::tie(a.corners, a.face) < std::tie(b.corners, b.face);
  });
  std::vector<Kept> kept;
  for (std::size_t i = 0, j; i < named.size(); i = j) {
    std::int32_t balance = 0;
    for (j = i; j < named.size() && named[j].corners == named[i].corners; ++j) {
      balance += named[j].odd ? -1 : 1;
    }
    std::size_t chosen = i, other = i;
    while (balance != 0 && named[chosen].odd != (balance < 0)) ++chosen;
    while (balance == 0 && named[other].odd == named[chosen].odd) ++other;
    kept.push_back({named[i].corners, named[chosen].face, named[other].face, balance == 0});
  }
  return kept;
}

// Of a sheet, by the faces of one side only, without the other.
struct Worth {
  std::int32_t closed_less_crowded = 0;  // edges
  bool free_edge = false;
};

// For each sheet, named by its lowest kept face.
std::vector<Worth> worth_of_sheets(const std::vector<Kept>& kept,
                                   std::vector<std::int32_t>& sheet) {
  std::vector<Side> sides;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const auto& [a, b, c] = kept[k].corners;
    const auto index = static_cast<std::int32_t>(k);
    sides.insert(sides.end(), {{a, b, index}, {b, c, index}, {a, c, index}});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    return std::tie(x.low, x.high, x.kept) < std::tie(y.low, y.high, y.kept);
  });
  const auto find = [&](std::int32_t k) {
    while (sheet[k] != k) k = sheet[k] = sheet[sheet[k]];
    return k;
  };
  const auto for_each_edge = [&](auto&& visit) {
    for (std::size_t i = 0, j; i < sides.size(); i = j) {
      j = i + 1;
      while (j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high) {
        ++j;
      }
      visit(i, j);
    }
  };
  for_each_edge([&](std::size_t i, std::size_t j) {
    std::int32_t joined = -1;
    for (; i < j; ++i) {
      if (!kept[sides[i].kept].two_sided) continue;
      const std::int32_t k = find(sides[i].kept);
      if (joined >= 0) sheet[std::max(joined, k)] = std::min(joined, k);
      joined = joined < 0 ? k : std::min(joined, k);
    }
  });
  std::vector<Worth> worth(kept.size());
  for_each_edge([&](std::size_t i, std::size_t j) {
    const auto others = std::count_if(sides.begin() + i, sides.begin() + j,
                                      [&](const Side& s) { return !kept[s.kept].two_sided; });
    if (others == 0) {
      if (j - i == 1) worth[find(sides[i].kept)].free_edge = true;
      return;
    }
    for (; i < j; ++i) {
      if (!kept[sides[i].kept].two_sided) continue;
      worth[find(sides[i].kept)].closed_less_crowded += others % 2 == 1 ? 1 : -1;
    }
  });
  for (std::size_t k = 0; k < kept.size(); ++k) sheet[k] = find(static_cast<std::int32_t>(k));
  return worth;
}

}  // namespace

std::vector<std::int32_t> distinct_faces(const std::vector<Triangle>& triangles,
                                         const std::vector<std::int32_t>& candidates) {
  std::vector<Named> named;
  named.reserve(candidates.size());
  for (std::int32_t f : candidates) named.push_back(name_of(triangles[f], f));
  const std::vector<Kept> kept = one_of_each(std::move(named));

  std::vector<std::int32_t> faces, sheet(kept.size());
  std::iota(sheet.begin(), sheet.end(), 0);
  const bool sheets =
      std::any_of(kept.begin(), kept.end(), [](const Kept& k) { return k.two_sided; });
  const std::vector<Worth> worth =
      sheets ? worth_of_sheets(kept, sheet) : std::vector<Worth>(kept.size());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const Worth& w = worth[sheet[k]];
    if (!kept[k].two_sided || w.closed_less_crowded >= 0) {
      faces.push_back(kept[k].face);
    } else if (!w.free_edge) {
      faces.push_back(kept[k].face);
      faces.push_back(kept[k].other_side);
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace craze
