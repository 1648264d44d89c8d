// The meaning of the attribute bytes as colours is that of VisCAM and SolidView, and of Magics.

#include <algorithm>

#include "craze/base/progress_meter.h"
#include "craze/base/text/format.h"
#include "craze/io/bytes/byte_order.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/stl/stl_facets.h"

namespace craze {

namespace {

constexpr std::size_t title_size = 80;
constexpr std::uint16_t flag = 1u << 15;

std::uint16_t attribute_of(const char* record) {
  return load<std::uint16_t>(record + stl_record_size - 2);
}

/// The end of the last record if each is as much longer as it says; 0 where the file is too short
/// for that.
std::size_t end_of_counted_records(std::string_view bytes, std::size_t count) {
  std::size_t at = stl_header_size;
  for (std::size_t i = 0; i < count; ++i) {
    if (bytes.size() - at < stl_record_size) return 0;
    const std::size_t extra = attribute_of(bytes.data() + at);
    at += stl_record_size;
    if (bytes.size() - at < extra) return 0;
    at += extra;
  }
  return at;
}

/// Five bits of a channel as 0 … 255.
double channel(std::uint16_t attribute, int shift) {
  return (((attribute >> shift) & 31) * 255 + 15) / 31;
}

/// Reads colours out of the attribute bytes of one face after another.
class FaceColors {
 public:
  explicit FaceColors(std::string_view bytes) {
    const std::string_view key = "COLOR=";
    const std::size_t at = bytes.substr(0, title_size).find(key);
    is_magics_ = at != std::string_view::npos && at + key.size() + 3 <= title_size;
    if (!is_magics_) return;
    for (std::size_t c = 0; c < 3; ++c) {
      whole_[c] = static_cast<unsigned char>(bytes[at + key.size() + c]);
    }
  }

  void add(std::uint16_t attribute) {
    // Magics: the flag means the colour of the whole; the others: a colour of the face's own.
    const bool has_own = is_magics_ ? (attribute & flag) == 0 : (attribute & flag) != 0;
    any_ = any_ || is_magics_ || has_own;
    for (int c = 0; c < 3; ++c) {
      const int shift = is_magics_ ? 5 * c : 10 - 5 * c;
      values_[c].push_back(has_own ? channel(attribute, shift) : whole_[c]);
    }
  }

  std::vector<Attribute> finish() {
    if (!any_) return {};
    return {{"red", 1, std::move(values_[0])},
            {"green", 1, std::move(values_[1])},
            {"blue", 1, std::move(values_[2])}};
  }

 private:
  bool is_magics_ = false, any_ = false;
  double whole_[3] = {255, 255, 255};
  std::vector<double> values_[3];
};

/// The header's text up to what it says of colours.
std::string title_of(std::string_view bytes) {
  std::string_view title = bytes.substr(0, title_size);
  for (const std::string_view key : {"COLOR=", "MATERIAL="}) {
    title = title.substr(0, std::min(title.find(key), title.size()));
  }
  title = title.substr(0, std::min(title.find('\0'), title.size()));
  const std::size_t last = title.find_last_not_of(" \t\r\n,;");
  title = title.substr(0, last == std::string_view::npos ? 0 : last + 1);
  return title == own_title ? std::string() : std::string(title);
}

}  // namespace

StlRecords find_stl_records(const MeshSource& source) {
  const std::string_view bytes = source.bytes;
  StlRecords records;
  records.count = load<std::uint32_t>(bytes.data() + title_size);
  const std::size_t held = (bytes.size() - stl_header_size) / stl_record_size;
  if (records.count > held) {
    fail_input(source.name,
               fmt::format("it promises {} triangles but holds {}", records.count, held));
  }
  records.unread = bytes.size() - stl_header_size - stl_record_size * records.count;
  // Attribute bytes are believed only where they account for every byte of the file.
  if (records.unread > 0 && end_of_counted_records(bytes, records.count) == bytes.size()) {
    records.counts_attribute_bytes = true;
    records.unread = 0;
  }
  return records;
}

StlFacets read_binary_stl(const MeshSource& source) {
  const StlRecords records = find_stl_records(source);
  ProgressMeter meter(source.context, "load", records.count);
  StlFacets facets;
  facets.title = title_of(source.bytes);
  facets.corners.reserve(3 * records.count);
  FaceColors colors(source.bytes);
  std::size_t attribute_bytes = 0;
  const char* record = source.bytes.data() + stl_header_size;
  for (std::size_t f = 0; f < records.count; ++f) {
    meter.at(f);
    const char* p = record + 12;  // after the normal
    for (int i = 0; i < 3; ++i, p += 12) {
      facets.corners.emplace_back(load<float>(p), load<float>(p + 4), load<float>(p + 8));
      if (!facets.corners.back().allFinite()) {
        fail_input(source.name, fmt::format("triangle {} has a coordinate that is not finite", f));
      }
    }
    const std::uint16_t attribute = attribute_of(record);
    record += stl_record_size;
    if (records.counts_attribute_bytes) {
      record += attribute;
      attribute_bytes += attribute;
    } else {
      colors.add(attribute);
    }
  }
  if (records.counts_attribute_bytes) {
    source.warn(fmt::format("{} attribute bytes of triangles are not kept", attribute_bytes));
  } else {
    facets.colors = colors.finish();
  }
  if (records.unread > 0) {
    source.warn(fmt::format("{} bytes after the last triangle are not read", records.unread));
  }
  return facets;
}

}  // namespace craze
