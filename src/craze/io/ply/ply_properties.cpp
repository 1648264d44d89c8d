#include "craze/io/ply/ply_properties.h"

#include <cctype>

#include "craze/base/text/format.h"
#include "craze/io/bytes/byte_order.h"

namespace craze {

void PlyProperties::add(const std::string& name, const char* type,
                        std::function<void(std::string&, std::size_t)> append_row) {
  header_ += fmt::format("property {} {}\n", type, unique(name));
  appenders_.push_back(std::move(append_row));
}

void PlyProperties::add_double(const std::string& name, std::function<double(std::size_t)> value) {
  add(name, "double", [value = std::move(value)](std::string& bytes, std::size_t row) {
    append(bytes, value(row));
  });
}

void PlyProperties::add_attribute(const Attribute& attribute,
                                  const std::function<std::size_t(std::size_t)>& row) {
  const auto n = static_cast<std::size_t>(attribute.components);
  for (std::size_t k = 0; k < n; ++k) {
    add_double(n == 1 ? attribute.name : fmt::format("{}_{}", attribute.name, k),
               [&attribute, n, k, row](std::size_t i) {
                 return attribute.values[n * (row ? row(i) : i) + k];
               });
  }
}

void PlyProperties::append_row(std::string& bytes, std::size_t row) const {
  for (const auto& appender : appenders_) appender(bytes, row);
}

std::string PlyProperties::unique(std::string name) {
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  }
  if (name.empty()) name = "unnamed";
  while (!names_.insert(name).second) name += '_';
  return name;
}

}  // namespace craze
