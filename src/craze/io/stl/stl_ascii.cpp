#include <algorithm>

#include "craze/base/progress_meter.h"
#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/bytes/text_cursor.h"
#include "craze/io/stl/stl_facets.h"

namespace craze {

namespace {

/// Bytes between two looks at the clock.
constexpr std::size_t meter_step = std::size_t{1} << 20;

bool equal_ignoring_case(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

/// The words of the file, wherever its lines end; only names take the rest of theirs.
class AsciiReader {
 public:
  explicit AsciiReader(const MeshSource& source)
      : text_(source.bytes, source.name),
        meter_(source.context, "load", source.bytes.size(), meter_step) {}

  StlFacets read() {
    while (text_.skip_blank()) {
      meter_.at(text_.offset());
      const std::string_view word = text_.word();
      if (equal_ignoring_case(word, "vertex")) {
        const double x = coordinate(), y = coordinate();
        corners_.emplace_back(x, y, coordinate());
        ++in_loop_;
      } else if (equal_ignoring_case(word, "endloop")) {
        if (in_loop_ != 3) text_.fail(fmt::format("a loop has {} vertices, not 3", in_loop_));
        in_loop_ = 0;
      } else if (equal_ignoring_case(word, "solid")) {
        read_name();
      } else if (equal_ignoring_case(word, "endsolid")) {
        skip_name();
      } else if (equal_ignoring_case(word, "facet")) {
        skip_normal();
      } else if (!equal_ignoring_case(word, "outer") && !equal_ignoring_case(word, "loop") &&
                 !equal_ignoring_case(word, "endfacet")) {
        text_.fail(fmt::format("'{}' is not a word of STL", printable(word)));
      }
    }
    if (in_loop_ != 0) text_.fail("the file ends within a facet");
    return {std::move(corners_), {}, std::move(solids_)};
  }

 private:
  double coordinate() {
    text_.skip_blank();
    return text_.number("a coordinate");
  }

  /// Whether the words here are "facet normal".
  bool at_facet() const {
    TextCursor ahead = text_;
    if (!equal_ignoring_case(ahead.word(), "facet")) return false;
    return ahead.skip_blank() && equal_ignoring_case(ahead.word(), "normal");
  }

  void skip_name() { static_cast<void>(name()); }

  std::string name() {
    std::string words;
    while (text_.more_on_line() && !at_facet()) {
      words += words.empty() ? "" : " ";
      words += text_.word();
    }
    return words;
  }

  void read_name() {
    constexpr std::size_t most = 10'000;
    std::string words = name();
    if (!words.empty() && solids_.size() < most) solids_.push_back(std::move(words));
  }

  /// Three numbers, or what stands for them; they follow from the corners.
  void skip_normal() {
    if (!text_.skip_blank()) return;
    TextCursor ahead = text_;
    if (!equal_ignoring_case(ahead.word(), "normal")) return;
    text_ = ahead;
    for (int i = 0; i < 3 && text_.skip_blank(); ++i) {
      ahead = text_;
      if (equal_ignoring_case(ahead.word(), "outer")) return;
      text_ = ahead;
    }
  }

  TextCursor text_;
  ProgressMeter meter_;
  std::vector<Vec3> corners_;
  std::vector<std::string> solids_;
  std::size_t in_loop_ = 0;
};

}  // namespace

StlFacets read_ascii_stl(const MeshSource& source) {
  return AsciiReader(source).read();
}

}  // namespace craze
