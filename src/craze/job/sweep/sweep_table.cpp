#include "craze/job/sweep/sweep_table.h"

#include <cmath>
#include <filesystem>
#include <optional>

#include "craze/base/text/format.h"
#include "craze/engine.h"
#include "craze/engine/cracked_surface.h"
#include "craze/error.h"
#include "craze/job/load_surface.h"
#include "craze/job/load_textures.h"
#include "craze/output/source_file.h"
#include "craze/products/statistics/quantities.h"

namespace craze {

namespace {

constexpr const char* counts[] = {"triangles", "events",    "fragments", "length",
                                  "load",      "junctions", "cells"};

std::string number_cell(double x) {
  return std::isfinite(x) ? fmt::format("{}", x) : "";
}

struct Measured {
  Report report;
  std::optional<Statistics> statistics;  ///< none where nothing cracked
};

Measured measure(const SweepRows& rows, std::uint64_t row, const PlanValues& values,
                 const std::string& folder, const Context& context) {
  const Recipe recipe = recipe_of(rows.plan(), values, rows.seed(row));
  std::string object = word_of(values, "object");
  if (!is_shape(object)) object = (std::filesystem::path(folder) / object).string();
  Input input;
  input.name = object;
  input.surface = std::make_shared<const SurfaceMesh>(load_surface(object, context).mesh);
  input.textures = load_textures(recipe, texture_folder(folder, recipe), context);
  const Result result = crack(std::move(input), recipe, {{}, OnCancel::discard}, context);
  Measured measured{result.report(), {}};
  const CrackedSurface& state = result.state();
  if (state.network.edges.empty()) return measured;
  StatisticsOptions options;
  options.bootstrap.context = context;
  measured.statistics =
      compute_statistics(graph_from_network(state.network, state.mesh()), options);
  return measured;
}

std::string number_cells(const Measured& measured) {
  const Report& r = measured.report;
  std::string cells =
      fmt::format(",{},{},{},{},{}", r.simulation.triangles, r.cracks.events, r.cracks.fragments,
                  number_cell(r.cracks.length), number_cell(r.load));
  const Statistics statistics = measured.statistics.value_or(Statistics{});
  cells += fmt::format(",{},{}", statistics.junctions, statistics.cells);
  for (const Quantity& q : quantities()) {
    const Estimate& e = statistics.*q.value;
    cells += "," + number_cell(e.value) + "," + number_cell(e.error);
  }
  return cells;
}

}  // namespace

std::vector<SweepColumn> sweep_columns(const SweepRows& rows) {
  std::vector<SweepColumn> columns{{"row"}, {"seed"}};
  for (const std::string& key : rows.varied()) {
    bool text = false;
    for (const PlanEntry& e : rows.plan().entries()) {
      if (e.key != key) continue;
      // A link without a map goes with a number, or is text.
      for (const PlanValue& v : extremes(e.distribution)) text |= v.index() == 1;
    }
    columns.push_back({key, text});
  }
  columns.push_back({"status", true});
  for (const char* count : counts) columns.push_back({count});
  for (const Quantity& q : quantities()) {
    columns.push_back({std::string(q.key)});
    columns.push_back({std::string(q.key) + ".error"});
  }
  return columns;
}

std::string sweep_row(const SweepRows& rows, std::uint64_t row, const std::string& folder,
                      const Context& context) {
  const PlanValues values = rows.values(row);
  std::string line = fmt::format("{},{}", row, rows.seed(row));
  for (const std::string& key : rows.varied()) line += "," + csv_cell(plan_text(values.at(key)));
  try {
    const Measured measured = measure(rows, row, values, folder, context);
    return line + ",ok" + number_cells(measured);
  } catch (const Error& e) {
    const std::size_t numbers = std::size(counts) + 2 * quantities().size();
    return line + "," + csv_cell(e.what()) + std::string(numbers, ',');
  }
}

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string cell = "\"";
  for (const char c : text) {
    if (c == '"') cell += '"';
    cell += c == '\n' || c == '\r' ? ' ' : c;  // a row is a line
  }
  return cell + "\"";
}

std::vector<std::string> csv_cells(std::string_view line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      if (quoted && i + 1 < line.size() && line[i + 1] == '"') {
        cells.back() += line[++i];
      } else {
        quoted = !quoted;
      }
    } else if (line[i] == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += line[i];
    }
  }
  return cells;
}

}  // namespace craze
