// How the rows of the parameter table are made: a field of a struct, with its type and default read
// off the struct itself.
#pragma once

#include <algorithm>
#include <type_traits>
#include <utility>

#include "craze/recipe/length_text.h"
#include "craze/recipe/parameter_table.h"

namespace craze {

namespace parameter_field {

// Fields of every type to values and back. Enumerations count from 0 in the order of `choices`.

inline ParameterValue to_value(double x, const Parameter&) {
  return x;
}
inline ParameterValue to_value(std::int64_t x, const Parameter&) {
  return x;
}
inline ParameterValue to_value(std::uint64_t x, const Parameter&) {
  return static_cast<std::int64_t>(x);
}
inline ParameterValue to_value(bool x, const Parameter&) {
  return x;
}
inline ParameterValue to_value(const std::vector<std::string>& x, const Parameter&) {
  return x;
}
inline ParameterValue to_value(const std::vector<double>& x, const Parameter&) {
  return x;
}
inline ParameterValue to_value(const std::string& x, const Parameter&) {
  return x;
}
inline ParameterValue to_value(const Vec3& x, const Parameter&) {
  return std::vector<double>{x.x(), x.y(), x.z()};
}
inline ParameterValue to_value(const std::array<double, 6>& x, const Parameter&) {
  return std::vector<double>(x.begin(), x.end());
}
inline ParameterValue to_value(const Length& x, const Parameter&) {
  if (x.unit() == LengthUnit::own) return x.number();
  return format_length(x);
}
inline ParameterValue to_value(const EdgeLength& x, const Parameter& p) {
  if (x.kind == EdgeLength::Kind::given) return to_value(x.length, p);
  return p.choices[static_cast<std::size_t>(x.kind)];
}
template <class Enum>
requires std::is_enum_v<Enum> ParameterValue to_value(Enum x, const Parameter& p) {
  return p.choices[static_cast<std::size_t>(x)];
}

inline std::ptrdiff_t choice_index(const Parameter& p, const std::string& word) {
  return std::find(p.choices.begin(), p.choices.end(), word) - p.choices.begin();
}

inline void from_value(const ParameterValue& v, const Parameter&, double& x) {
  x = std::get<double>(v);
}
inline void from_value(const ParameterValue& v, const Parameter&, std::int64_t& x) {
  x = std::get<std::int64_t>(v);
}
inline void from_value(const ParameterValue& v, const Parameter&, std::uint64_t& x) {
  x = static_cast<std::uint64_t>(std::get<std::int64_t>(v));
}
inline void from_value(const ParameterValue& v, const Parameter&, bool& x) {
  x = std::get<bool>(v);
}
inline void from_value(const ParameterValue& v, const Parameter&, std::vector<std::string>& x) {
  x = std::get<std::vector<std::string>>(v);
}
inline void from_value(const ParameterValue& v, const Parameter&, std::vector<double>& x) {
  x = std::get<std::vector<double>>(v);
}
inline void from_value(const ParameterValue& v, const Parameter&, std::string& x) {
  x = std::get<std::string>(v);
}
inline void from_value(const ParameterValue& v, const Parameter&, Vec3& x) {
  const auto& numbers = std::get<std::vector<double>>(v);
  x = Vec3(numbers[0], numbers[1], numbers[2]);
}
inline void from_value(const ParameterValue& v, const Parameter&, std::array<double, 6>& x) {
  const auto& numbers = std::get<std::vector<double>>(v);
  std::copy(numbers.begin(), numbers.end(), x.begin());
}
inline void from_value(const ParameterValue& v, const Parameter&, Length& x) {
  const auto* text = std::get_if<std::string>(&v);
  x = text ? *parse_length(*text) : Length(std::get<double>(v));
}
inline void from_value(const ParameterValue& v, const Parameter& p, EdgeLength& x) {
  const auto* word = std::get_if<std::string>(&v);
  if (word && !parse_length(*word)) {
    x = {static_cast<EdgeLength::Kind>(choice_index(p, *word)), 0};
  } else {
    x.kind = EdgeLength::Kind::given;
    from_value(v, p, x.length);
  }
}
template <class Enum>
requires std::is_enum_v<Enum>
void from_value(const ParameterValue& v, const Parameter& p, Enum& x) {
  x = static_cast<Enum>(choice_index(p, std::get<std::string>(v)));
}

template <class Field>
constexpr ParameterType type_of() {
  if constexpr (std::is_same_v<Field, double>) return ParameterType::real;
  if constexpr (std::is_same_v<Field, bool>) return ParameterType::boolean;
  if constexpr (std::is_same_v<Field, std::vector<std::string>>) return ParameterType::names;
  if constexpr (std::is_same_v<Field, std::vector<double>>) return ParameterType::vec2;
  if constexpr (std::is_integral_v<Field>) return ParameterType::integer;
  if constexpr (std::is_enum_v<Field>) return ParameterType::choice;
  if constexpr (std::is_same_v<Field, Vec3>) return ParameterType::vec3;
  if constexpr (std::is_same_v<Field, std::array<double, 6>>) return ParameterType::tensor6;
  if constexpr (std::is_same_v<Field, Length>) return ParameterType::length;
  if constexpr (std::is_same_v<Field, EdgeLength>) return ParameterType::edge;
  return ParameterType::string;
}

}  // namespace parameter_field

/// What is written of a parameter besides its field: everything has a default but the help.
struct Text {
  const char* help;
  const char* symbol = "";
  const char* unit = "";
  const char* source = "";
  std::vector<std::string> choices = {};
  const char* instead_of = "";
};

/// Appends the parameters of one section. locate(recipe, index) is the struct that holds them.
template <class Locate>
class Section {
 public:
  Section(std::vector<Parameter>& table, std::string prefix, Locate locate)
      : table_(table), prefix_(std::move(prefix)), locate_(locate) {}

  template <class Struct, class Field>
  Section& add(const char* name, Field Struct::*field, ParameterRange range, Text text) {
    Parameter p;
    p.key = prefix_ + name;
    p.type = parameter_field::type_of<Field>();
    p.range = range;
    p.choices = std::move(text.choices);
    p.symbol = text.symbol;
    p.unit = text.unit;
    p.help = text.help;
    p.source = text.source;
    p.instead_of = text.instead_of;
    // The conversions need the words allowed only, so they carry a parameter without functions.
    const Parameter words = p;
    p.get = [words, field, locate = locate_](const Recipe& r, std::size_t index) {
      return parameter_field::to_value(locate(r, index).*field, words);
    };
    p.set = [words, field, locate = locate_](Recipe& r, std::size_t index,
                                             const ParameterValue& v) {
      parameter_field::from_value(v, words, locate(r, index).*field);
    };
    table_.push_back(std::move(p));
    return *this;
  }

 private:
  std::vector<Parameter>& table_;
  std::string prefix_;
  Locate locate_;
};

}  // namespace craze
