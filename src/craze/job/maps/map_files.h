// Files of maps, and maps.json beside them.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "craze/context.h"
#include "craze/io/image/row_image.h"
#include "craze/job/maps/write_maps.h"
#include "craze/maps.h"

namespace craze {

/// Writes the files of one set or tile after the other. References must outlive it.
class MapFiles : public MapSink {
 public:
  MapFiles(const MapsRequest& request, const Context& context)
      : request_(request), context_(context) {}

  void begin(const std::vector<MapHeader>& headers) override;
  void rows(int first, int count, const std::vector<const float*>& maps) override;
  void end() override;

  /// maps.json, with the members of `more` before the list of maps.
  void write_description(const nlohmann::ordered_json& more) const;

 private:
  std::unique_ptr<RowImage> new_file(const MapHeader& header) const;

  const MapsRequest& request_;
  const Context& context_;
  std::vector<MapHeader> headers_;
  std::vector<std::unique_ptr<RowImage>> files_;
  nlohmann::ordered_json described_ = nlohmann::ordered_json::array();
};

}  // namespace craze
