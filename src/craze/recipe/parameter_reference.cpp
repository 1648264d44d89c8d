#include "craze/recipe/parameter_reference.h"

#include "craze/base/text/format.h"
#include "craze/presets.h"
#include "craze/recipe/parameter_table.h"

namespace craze {

namespace {

/// What may stand on the right of "=": the choices, or the range.
std::string allowed(const Parameter& p) {
  std::string words;
  for (const std::string& choice : p.choices) words += (words.empty() ? "" : ", ") + choice;
  switch (p.type) {
    case ParameterType::choice:
      return words;
    case ParameterType::edge:
      return words + ", or " + range_in_words(p.range, p.type) + ", or with a unit";
    case ParameterType::string:
      return "text";
    case ParameterType::boolean:
      return "true or false";
    case ParameterType::names:
      return "names, with * and ?";
    case ParameterType::vec2:
      return "[u, v]";
    case ParameterType::vec3:
      return "[x, y, z]";
    case ParameterType::tensor6:
      return "[xx, yy, zz, xy, yz, zx]";
    case ParameterType::integer:
      return "whole number, " + range_in_words(p.range, p.type);
    case ParameterType::real:
    case ParameterType::length:
      break;
  }
  return range_in_words(p.range, p.type) + (p.is_length() ? ", or with a unit" : "");
}

std::string section_heading(const Parameter& p) {
  if (p.section().empty()) return "Top level";
  return p.repeated() ? fmt::format("[[{}]]", p.section()) : fmt::format("[{}]", p.section());
}

/// "σ₀, stress": the symbol and the unit, as far as given.
std::string symbol_and_unit(const Parameter& p) {
  return p.symbol + (p.symbol.empty() || p.unit.empty() ? "" : ", ") + p.unit;
}

}  // namespace

std::string parameter_listing() {
  std::string text;
  std::string heading;
  for (const Parameter& p : parameter_table()) {
    if (section_heading(p) != heading) {
      heading = section_heading(p);
      text += (text.empty() ? "" : "\n") + heading + "\n";
    }
    text +=
        fmt::format("  {:<28} {}\n", p.name() + " = " + format_value(p.default_value()), p.help);
    const std::string symbol = symbol_and_unit(p);
    text +=
        fmt::format("  {:<28} {}{}{}\n", "", allowed(p), symbol.empty() ? "" : "  (" + symbol + ")",
                    p.source.empty() ? "" : "  " + p.source);
  }
  return text;
}

std::string parameter_page() {
  std::string text =
      "# Recipe reference\n\n"
      "<!-- Written by `craze parameters --markdown`; change "
      "src/craze/recipe/parameter_table.cpp "
      "instead. -->\n\n"
      "A recipe is a TOML file with the keys below; what it leaves out keeps its default.\n"
      "`--set section.key=value` takes the same keys, `--set impact.0.radius=2` those of the "
      "first\n"
      "impact. An unknown key, a wrong type or a value out of range is an error.\n\n"
      "A length is a bare number in the mesh's own unit, or a text: `\"4mm\"`, `\"0.5in\"`, also "
      "in "
      "`um`,\n`cm`, `m`, `km` and `ft`, or `\"3%\"` of the diagonal of the box around the object. "
      "glTF is in\nmetres; for files that do not say, `mesh.unit` does. The report has the numbers "
      "that came of them.\nA position is in the mesh's own unit. A stress is a force per "
      "length,\nrelative to whatever the material's toughness is given in. [IO06] is Iben and\n"
      "O'Brien, *Generating Surface Crack Patterns*, SCA 2006; [CSM03] is Cohen-Steiner and "
      "Morvan,\n"
      "*Restricted Delaunay Triangulations and Normal Cycle*, SCG 2003.\n";
  std::string heading;
  for (const Parameter& p : parameter_table()) {
    if (section_heading(p) != heading) {
      heading = section_heading(p);
      const std::string title = p.section().empty() ? heading : "`" + heading + "`";
      text += "\n## " + title + "\n\n| key | default | allowed | symbol, unit | what it does |\n" +
              "|---|---|---|---|---|\n";
    }
    text +=
        fmt::format("| `{}` | `{}` | {} | {} | {}{} |\n", p.name(), format_value(p.default_value()),
                    allowed(p), symbol_and_unit(p), p.help, p.source.empty() ? "" : " " + p.source);
  }
  text += "\n## Presets\n\n| name | what it is |\n|---|---|\n";
  for (const Preset& preset : presets()) {
    text += fmt::format("| `{}` | {} |\n", preset.name, preset.description());
  }
  return text;
}

}  // namespace craze
