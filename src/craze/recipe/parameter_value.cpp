#include "craze/recipe/parameter_value.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "craze/base/text/format.h"

namespace craze {

namespace {

std::string format_real(double x) {
  std::string text = fmt::format("{}", x);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string quote(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      quoted += fmt::format("\\u{:04X}", byte);
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

struct Formatter {
  std::string operator()(double x) const { return format_real(x); }
  std::string operator()(std::int64_t x) const { return std::to_string(x); }
  std::string operator()(bool x) const { return x ? "true" : "false"; }
  std::string operator()(const std::string& x) const { return quote(x); }
  template <class T>
  std::string operator()(const std::vector<T>& x) const {
    std::string text = "[";
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (i > 0) text += ", ";
      text += (*this)(x[i]);
    }
    return text + "]";
  }
};

}  // namespace

std::string type_name(ParameterType type) {
  switch (type) {
    case ParameterType::real:
    case ParameterType::length:
      return "real";
    case ParameterType::integer:
      return "integer";
    case ParameterType::boolean:
      return "boolean";
    case ParameterType::choice:
      return "choice";
    case ParameterType::string:
      return "string";
    case ParameterType::names:
      return "names";
    case ParameterType::vec2:
      return "vec2";
    case ParameterType::vec3:
      return "vec3";
    case ParameterType::tensor6:
      return "tensor6";
    case ParameterType::edge:
      return "edge";
  }
  return "";
}

std::string type_in_words(ParameterType type) {
  switch (type) {
    case ParameterType::real:
      return "a number";
    case ParameterType::integer:
      return "a whole number";
    case ParameterType::boolean:
      return "true or false";
    case ParameterType::choice:
      return "a word";
    case ParameterType::string:
      return "a text";
    case ParameterType::names:
      return "a list of names [\"a\", \"b*\"]";
    case ParameterType::vec2:
      return "two numbers [u, v], or none []";
    case ParameterType::vec3:
      return "three numbers [x, y, z]";
    case ParameterType::tensor6:
      return "six numbers [xx, yy, zz, xy, yz, zx]";
    case ParameterType::length:
      return "a number, or one with a unit, such as 4mm or 3%";
    case ParameterType::edge:
      return "\"auto\", \"keep\" or a length";
  }
  return "";
}

std::string range_in_words(const ParameterRange& range, ParameterType type) {
  const auto number = [&](double x) {
    return type == ParameterType::integer ? fmt::format("{:.0f}", x) : fmt::format("{}", x);
  };
  const bool low = std::isfinite(range.low), high = std::isfinite(range.high);
  if (low && high) {
    return fmt::format("in {}{}, {}]", range.low_open ? '(' : '[', number(range.low),
                       number(range.high));
  }
  if (low) return (range.low_open ? "more than " : "at least ") + number(range.low);
  if (high) return "at most " + number(range.high);
  return type == ParameterType::integer ? "any whole number" : "any finite number";
}

std::string format_value(const ParameterValue& value) {
  return std::visit(Formatter{}, value);
}

nlohmann::ordered_json value_to_json(const ParameterValue& value) {
  return std::visit([](const auto& x) { return nlohmann::ordered_json(x); }, value);
}

}  // namespace craze
