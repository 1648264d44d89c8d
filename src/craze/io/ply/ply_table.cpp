#include "craze/io/ply/ply_table.h"

#include <bit>

#include "craze/base/text/format.h"
#include "craze/io/bytes/byte_order.h"
#include "craze/io/bytes/input_error.h"

namespace craze {

namespace {

double load_as(PlyType type, const char* p, std::endian order) {
  switch (type) {
    case PlyType::int8:
      return load<std::int8_t>(p, order);
    case PlyType::uint8:
      return load<std::uint8_t>(p, order);
    case PlyType::int16:
      return load<std::int16_t>(p, order);
    case PlyType::uint16:
      return load<std::uint16_t>(p, order);
    case PlyType::int32:
      return load<std::int32_t>(p, order);
    case PlyType::uint32:
      return load<std::uint32_t>(p, order);
    case PlyType::int64:
      return static_cast<double>(load<std::int64_t>(p, order));
    case PlyType::uint64:
      return static_cast<double>(load<std::uint64_t>(p, order));
    case PlyType::float32:
      return load<float>(p, order);
    case PlyType::float64:
      return load<double>(p, order);
  }
  return 0;
}

/// The fewest bytes a row can take; a list may be empty.
std::size_t smallest_row(const PlyElement& element, PlyFormat format) {
  std::size_t size = 0;
  for (const PlyProperty& p : element.properties) {
    // In text, a digit and the space or newline before the next one.
    size += format == PlyFormat::ascii ? 2 : size_of(p.is_list ? p.count_type : p.type);
  }
  return size;
}

bool has_list(const PlyElement& element) {
  for (const PlyProperty& p : element.properties) {
    if (p.is_list) return true;
  }
  return false;
}

}  // namespace

PlyBody::PlyBody(const MeshSource& source, const PlyHeader& header)
    : header_(header),
      name_(source.name),
      size_(source.bytes.size()),
      meter_(source.context, "load", size_, std::size_t{1} << 20),
      rest_(source.bytes.substr(header.size)),
      text_(rest_, name_, header.lines + 1),
      text_at_start_(text_) {}

void PlyBody::fail_short(const PlyElement& element) const {
  fail_input(name_, fmt::format("it is too short for the {} '{}' rows its header promises",
                                element.count, printable(element.name)));
}

std::vector<PlyColumn> PlyBody::read(const PlyElement& element) {
  std::vector<PlyColumn> columns(element.properties.size());
  if (element.count == 0 || columns.empty()) return columns;
  const bool ascii = header_.format == PlyFormat::ascii;
  // The last number of a text needs no newline after it.
  const std::size_t available = ascii ? text_.remaining() + 1 : rest_.size();
  if (element.count > available / smallest_row(element, header_.format)) fail_short(element);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (element.properties[i].is_list) {
      columns[i].ends.reserve(element.count);
      columns[i].values.reserve(3 * element.count);
    } else {
      columns[i].values.resize(element.count);
    }
  }
  if (ascii) {
    read_ascii(element, columns);
  } else if (has_list(element)) {
    read_lists(element, columns);
  } else {
    read_fixed(element, columns);
  }
  return columns;
}

void PlyBody::read_ascii(const PlyElement& element, std::vector<PlyColumn>& columns) {
  const auto number = [&](const PlyProperty& p) {
    if (!text_.skip_blank()) fail_short(element);
    return text_.any_number(p.name.c_str());
  };
  for (std::size_t row = 0; row < element.count; ++row) {
    meter_.at(size_ - text_.remaining());
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      PlyColumn& column = columns[i];
      if (!property.is_list) {
        column.values[row] = number(property);
        continue;
      }
      if (!text_.skip_blank()) fail_short(element);
      const std::int64_t length = text_.integer("a list's length");
      if (length < 0) text_.fail("a list's length is negative");
      for (std::int64_t k = 0; k < length; ++k) column.values.push_back(number(property));
      column.ends.push_back(column.values.size());
    }
    skip_surplus();
  }
}

std::size_t PlyBody::unread() {
  if (header_.format != PlyFormat::ascii) return rest_.size();
  return text_.skip_blank() ? text_.remaining() : 0;
}

void PlyBody::skip_surplus() {
  if (!text_.more_on_line()) return;
  if (!line_per_row_) {
    // Numbers left over mean that rows are longer than declared, if there is a line for each row.
    std::size_t rows = 0;
    for (const PlyElement& e : header_.elements) rows += e.properties.empty() ? 0 : e.count;
    TextCursor lines = text_at_start_;
    std::size_t count = 0;
    for (; count < rows && lines.skip_blank(); ++count) lines.skip_line();
    line_per_row_ = count == rows;
  }
  if (!*line_per_row_) return;
  ++surplus_rows_;
  text_.skip_line();
}

void PlyBody::read_fixed(const PlyElement& element, std::vector<PlyColumn>& columns) {
  const auto order =
      header_.format == PlyFormat::binary_big_endian ? std::endian::big : std::endian::little;
  const std::size_t stride = smallest_row(element, header_.format);
  std::size_t offset = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    meter_.at(size_ - rest_.size());
    const PlyType type = element.properties[i].type;
    const char* p = rest_.data() + offset;
    for (double& value : columns[i].values) {
      value = load_as(type, p, order);
      p += stride;
    }
    offset += size_of(type);
  }
  rest_.remove_prefix(stride * element.count);
}

double PlyBody::next(PlyType type) {
  const auto order =
      header_.format == PlyFormat::binary_big_endian ? std::endian::big : std::endian::little;
  const double value = load_as(type, rest_.data(), order);
  rest_.remove_prefix(size_of(type));
  return value;
}

void PlyBody::read_lists(const PlyElement& element, std::vector<PlyColumn>& columns) {
  for (std::size_t row = 0; row < element.count; ++row) {
    meter_.at(size_ - rest_.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      const PlyType first = property.is_list ? property.count_type : property.type;
      if (rest_.size() < size_of(first)) fail_short(element);
      const double value = next(first);
      if (!property.is_list) {
        columns[i].values[row] = value;
        continue;
      }
      if (value < 0) {
        fail_input(name_, fmt::format("'{}' row {} has a list of negative length",
                                      printable(element.name), row));
      }
      const auto length = static_cast<std::size_t>(value);
      if (length > rest_.size() / size_of(property.type)) fail_short(element);
      for (std::size_t k = 0; k < length; ++k) columns[i].values.push_back(next(property.type));
      columns[i].ends.push_back(columns[i].values.size());
    }
  }
}

}  // namespace craze
