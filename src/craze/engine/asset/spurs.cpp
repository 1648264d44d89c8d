#include "craze/engine/asset/spurs.h"

#include <algorithm>
#include <utility>

namespace craze {

namespace {

/// What meets in a site.
struct Meeting {
  std::int32_t lines = 0;
  std::int32_t line_xor = 0;   // of their indices: of the last one that is left its own
  bool is_end = false;         // of an odd number of ways
  std::int32_t moved_to = -1;  // the site that stands for it now
};

}  // namespace

void drop_spurs(const std::vector<CurvePiece>& pieces, RefinedAsset& refined) {
  if (refined.lost_segments > 0) return;
  std::size_t sites = refined.same_site.size();
  for (const CurveLine& line : refined.lines) {
    sites = std::max(sites, static_cast<std::size_t>(line.b) + 1);
  }
  std::vector<Meeting> at(sites);
  for (const CurvePiece& piece : pieces) {
    for (const std::int32_t s : {piece.from, piece.to}) {
      bool& is_end = at[refined.same_site[s]].is_end;
      is_end = !is_end;
    }
  }
  for (std::size_t k = 0; k < refined.lines.size(); ++k) {
    for (const std::int32_t s : {refined.lines[k].a, refined.lines[k].b}) {
      ++at[s].lines;
      at[s].line_xor ^= static_cast<std::int32_t>(k);
    }
  }
  std::vector<char> dropped(refined.lines.size(), 0);
  bool any = false;
  for (std::size_t first = 0; first < sites; ++first) {
    auto s = static_cast<std::int32_t>(first);
    while (at[s].lines == 1 && !at[s].is_end) {
      const std::int32_t k = at[s].line_xor;
      const CurveLine& line = refined.lines[k];
      const std::int32_t other = line.a == s ? line.b : line.a;
      dropped[k] = 1;
      any = true;
      at[s].lines = 0;
      at[s].moved_to = other;
      --at[other].lines;
      at[other].line_xor ^= k;
      s = other;
    }
  }
  if (!any) return;
  for (std::int32_t& s : refined.same_site) {
    while (at[s].moved_to >= 0) s = at[s].moved_to;
  }
  std::vector<CurveLine> kept;
  for (std::size_t k = 0; k < dropped.size(); ++k) {
    if (!dropped[k]) kept.push_back(refined.lines[k]);
  }
  refined.lines = std::move(kept);
}

}  // namespace craze
