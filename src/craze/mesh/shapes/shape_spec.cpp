#include "craze/mesh/shapes/shape_spec.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <numeric>
#include <set>
#include <sstream>

#include "craze/error.h"

namespace craze {

namespace {

std::string shortest(double x) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << x;
  return out.str();
}

std::string quoted(std::string_view s) {
  return "'" + std::string(s) + "'";
}

// Levenshtein distance: insertions, deletions and replacements that turn a into b.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

template <class Entry>
[[noreturn]] void unknown(const std::string& kind, std::string_view name,
                          std::string_view specification, const std::vector<Entry>& known) {
  const auto nearest =
      std::min_element(known.begin(), known.end(), [&](const Entry& x, const Entry& y) {
        return edit_distance(name, x.name) < edit_distance(name, y.name);
      });
  std::string why = "did you mean " + quoted(nearest->name) + "? Known:";
  for (const Entry& e : known) why.append(1, ' ').append(e.name);
  throw Error(ErrorKind::usage, "no such " + kind + " " + quoted(name),
              "shape:" + std::string(specification), why);
}

double parse_value(const ShapeParameter& p, std::string_view text, std::string_view specification) {
  std::istringstream in{std::string(text)};
  in.imbue(std::locale::classic());
  double value = 0;
  const bool number =
      static_cast<bool>(in >> value) && in.peek() == std::istringstream::traits_type::eof();
  const bool fits =
      number && value >= p.low && value <= p.high && (!p.integer || value == std::floor(value));
  if (fits) return value;
  throw Error(ErrorKind::usage, "bad value " + quoted(text) + " for " + quoted(p.name),
              "shape:" + std::string(specification),
              std::string(p.integer ? "a whole number" : "a number") + " from " + shortest(p.low) +
                  " to " + shortest(p.high) + " is needed");
}

}  // namespace

ShapeSpec parse_shape(std::string_view specification) {
  const std::size_t mark = std::min(specification.find('?'), specification.size());
  const std::string_view name = specification.substr(0, mark);
  ShapeSpec spec{nullptr, {}};
  for (const ShapeInfo& s : shape_table()) {
    if (s.name == name) spec.shape = &s;
  }
  if (!spec.shape) unknown("shape", name, specification, shape_table());
  const auto& parameters = spec.shape->parameters;
  for (const ShapeParameter& p : parameters) spec.values[p.name] = p.standard;

  std::set<std::string_view> given;
  std::string_view rest = specification.substr(std::min(mark + 1, specification.size()));
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('&'), rest.size());
    const std::string_view pair = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::size_t equals = std::min(pair.find('='), pair.size());
    const std::string_view key = pair.substr(0, equals);
    const auto p = std::find_if(parameters.begin(), parameters.end(),
                                [&](const ShapeParameter& x) { return x.name == key; });
    if (p == parameters.end()) unknown("shape parameter", key, specification, parameters);
    if (!given.insert(p->name).second) {
      throw Error(ErrorKind::usage, quoted(key) + " is given twice",
                  "shape:" + std::string(specification), "leave one of them out");
    }
    spec.values[p->name] =
        parse_value(*p, pair.substr(std::min(equals + 1, pair.size())), specification);
  }
  return spec;
}

std::string shape_help() {
  std::string help;
  for (const ShapeInfo& s : shape_table()) {
    help += std::string(s.name) + "  " + std::string(s.text) + "\n";
    for (const ShapeParameter& p : s.parameters) {
      std::string entry = "    " + std::string(p.name) + " = " + shortest(p.standard);
      entry.resize(std::max<std::size_t>(entry.size() + 2, 22), ' ');
      help +=
          entry + std::string(p.text) + " (" + shortest(p.low) + " … " + shortest(p.high) + ")\n";
    }
  }
  return help;
}

}  // namespace craze
