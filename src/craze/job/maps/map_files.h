// Files of maps, and maps.json beside them.
#pragma once

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "craze/context.h"
#include "craze/io/image/row_image.h"
#include "craze/job/maps/write_maps.h"
#include "craze/maps.h"

namespace craze {

/// Writes the files of one set or tile after the other. References must outlive it.
class MapFiles : public MapSink {
 public:
  /// uv_sets: of each material, where the maps lie in others than the first.
  MapFiles(const MapsRequest& request, std::map<std::int32_t, std::size_t> uv_sets,
           const Context& context)
      : request_(request), uv_sets_(std::move(uv_sets)), context_(context) {}

  void begin(const std::vector<MapHeader>& headers) override;
  void rows(int first, int count, const std::vector<const float*>& maps) override;
  void end() override;

  /// maps.json, with the members of `more` before the list of maps.
  void write_description(const nlohmann::ordered_json& more) const;

 private:
  std::unique_ptr<RowImage> new_file(const MapHeader& header) const;

  const MapsRequest& request_;
  std::map<std::int32_t, std::size_t> uv_sets_;
  const Context& context_;
  std::vector<MapHeader> headers_;
  std::vector<std::unique_ptr<RowImage>> files_;
  nlohmann::ordered_json described_ = nlohmann::ordered_json::array();
};

}  // namespace craze
