// The report of a run as JSON, for files and other programs.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "craze/products/statistics/statistics_report.h"
#include "craze/report.h"

namespace craze {

/// Keys: version seed threads engine; input, simulation, output .{vertices,triangles};
/// cracks.{events,segments,length,fragments};
/// carried.{split_triangles,added_triangles,rerouted_pieces,lost_pieces,lost_length}; load;
/// stop_reason; warnings; time.{total,load,prepare,relax,separation,crack,carry,write}; statistics
/// (empty where none are given); repair; recipe.
nlohmann::ordered_json report_to_json(const Report& report,
                                      const StatisticsWithSensitivity* statistics);

/// What repair found and did, one number per kind.
nlohmann::ordered_json repair_to_json(const RepairReport& repair);

/// That as indented text, valid UTF-8 whatever bytes the input's names are.
std::string report_text(const Report& report, const StatisticsWithSensitivity* statistics);

}  // namespace craze
