#include "craze/products/statistics/statistics_report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "craze/base/text/format.h"
#include "craze/products/statistics/quantities.h"

namespace craze {

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson number(double x) {
  return std::isfinite(x) ? OrderedJson(x) : OrderedJson(nullptr);
}

/// Sets object.a.b for the key "a.b".
void set(OrderedJson& object, std::string_view key, OrderedJson value) {
  const std::size_t dot = key.find('.');
  OrderedJson& inner =
      dot == std::string_view::npos
          ? object[std::string(key)]
          : object[std::string(key.substr(0, dot))][std::string(key.substr(dot + 1))];
  inner = std::move(value);
}

OrderedJson values(const Statistics& s) {
  OrderedJson object;
  for (const Quantity& q : quantities()) set(object, q.key, number((s.*q.value).value));
  return object;
}

std::string cell(double x) {
  return std::isfinite(x) ? fmt::format("{:10.4g}", x) : "         -";
}

}  // namespace

std::vector<NullRow> null_rows(const StatisticsOptions& options, std::int32_t cells,
                               std::uint64_t seed) {
  StatisticsOptions quick = options;
  quick.axis = Vec3::UnitX();
  quick.bootstrap.resamples = 0;
  std::vector<NullRow> rows;
  for (const NullModel model :
       {NullModel::poisson_voronoi, NullModel::orthogonal_splitting, NullModel::stit}) {
    rows.push_back({model, compute_statistics(null_graph(model, cells, seed), quick)});
  }
  return rows;
}

nlohmann::ordered_json to_json(const StatisticsWithSensitivity& s,
                               const std::vector<NullRow>& nulls) {
  OrderedJson json;
  json["counts"] = {{"junctions", s.result.junctions},
                    {"cells", s.result.cells},
                    {"cells_found", s.result.cells_found},
                    {"edges", s.result.edges}};
  json["crack_length"] = number(s.result.crack_length);
  json["surface_area"] = s.result.surface_area > 0 ? OrderedJson(s.result.surface_area) : nullptr;
  for (const Quantity& q : quantities()) {
    const Estimate& e = s.result.*q.value;
    set(json, q.key, {{"value", number(e.value)}, {"error", number(e.error)}});
  }
  json["sensitivity"] = {{"half", values(s.at_half)}, {"double", values(s.at_double)}};
  for (const NullRow& row : nulls)
    json["null"][std::string(to_string(row.model))] = values(row.statistics);
  return json;
}

std::string to_text(const StatisticsWithSensitivity& s, const std::vector<NullRow>& nulls) {
  std::string text = fmt::format(
      "{} junctions, {} cells ({} with those at the border), {} lines, crack length {:.6g}\n\n",
      s.result.junctions, s.result.cells, s.result.cells_found, s.result.edges,
      s.result.crack_length);
  text += fmt::format("{:<52}{:>10} {:>9}{:>10}{:>10}", "", "value", "error", "half", "double");
  for (const NullRow& row : nulls) text += fmt::format("{:>11}", to_string(row.model));
  text += '\n';
  for (const Quantity& q : quantities()) {
    const Estimate& e = s.result.*q.value;
    const std::string error = std::isfinite(e.error) ? fmt::format("{:.2g}", e.error) : "";
    text += fmt::format("{:<52}{} {:>9}{}{}", q.text, cell(e.value), error,
                        cell((s.at_half.*q.value).value), cell((s.at_double.*q.value).value));
    for (const NullRow& row : nulls) text += " " + cell((row.statistics.*q.value).value);
    text += '\n';
  }
  text +=
      "\nhalf, double: with the length below which spurs and edges are removed halved and "
      "doubled.\n"
      "The last columns are patterns without mechanics, measured by the same code.\n";
  return text;
}

}  // namespace craze
