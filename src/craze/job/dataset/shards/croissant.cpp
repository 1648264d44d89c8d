#include "craze/job/dataset/shards/croissant.h"

#include <nlohmann/json.hpp>

#include "craze/base/version.h"
#include "craze/job/dataset/shards/shard_files.h"

namespace craze {

namespace {

using Json = nlohmann::ordered_json;

Json context_json() {
  return {{"@language", "en"},
          {"@vocab", "https://schema.org/"},
          {"sc", "https://schema.org/"},
          {"cr", "http://mlcommons.org/croissant/"},
          {"dct", "http://purl.org/dc/terms/"},
          {"conformsTo", "dct:conformsTo"},
          {"recordSet", "cr:recordSet"},
          {"field", "cr:field"},
          {"dataType", {{"@id", "cr:dataType"}, {"@type", "@vocab"}}},
          {"source", "cr:source"},
          {"extract", "cr:extract"},
          {"fileProperty", "cr:fileProperty"},
          {"fileObject", "cr:fileObject"},
          {"fileSet", "cr:fileSet"},
          {"includes", "cr:includes"}};
}

Json field(const char* name, const char* type, const char* files, const char* text) {
  return {{"@type", "cr:Field"},
          {"@id", std::string("samples/") + name},
          {"name", name},
          {"description", text},
          {"dataType", type},
          {"source", {{"fileSet", {{"@id", files}}}, {"extract", {{"fileProperty", "content"}}}}}};
}

}  // namespace

std::string croissant_json(const DatasetPlan& plan, const std::filesystem::path& folder) {
  Json files = Json::array(), archives = Json::array();
  for (std::uint64_t s = 0; s < plan.shape.shards(); ++s) {
    const ShardPaths paths = shard_paths(folder, s);
    const auto mark = read_mark(plan.shape, folder, s);
    const std::string name = "shards/" + paths.tar.filename().string();
    files.push_back({{"@type", "cr:FileObject"},
                     {"@id", name},
                     {"name", name},
                     {"contentUrl", name},
                     {"contentSize", std::to_string(mark ? mark->bytes : 0) + " B"},
                     {"encodingFormat", "application/x-tar"},
                     {"sha256", mark ? mark->tar_sha256 : ""}});
    archives.push_back({{"@id", name}});
  }
  for (const char* kind : {"image", "mask", "width"}) {
    files.push_back({{"@type", "cr:FileSet"},
                     {"@id", std::string(kind) + "-files"},
                     {"name", std::string(kind) + "-files"},
                     {"containedIn", archives},
                     {"encodingFormat", "image/png"},
                     {"includes", std::string("*.") + kind + ".png"}});
  }
  if (plan.shape.points > 0) {
    files.push_back({{"@type", "cr:FileSet"},
                     {"@id", "points-files"},
                     {"name", "points-files"},
                     {"containedIn", archives},
                     {"encodingFormat", "application/octet-stream"},
                     {"includes", "*.points.ply"}});
  }
  const Json json{
      {"@context", context_json()},
      {"@type", "sc:Dataset"},
      {"conformsTo", "http://mlcommons.org/croissant/1.0"},
      {"name", "cracks"},
      {"description", "Pictures of simulated cracks with exact labels, made by craze " + version() +
                          " from the plan beside this file"},
      {"version", "1.0.0"},
      {"distribution", files},
      {"recordSet",
       {{{"@type", "cr:RecordSet"},
         {"@id", "samples"},
         {"name", "samples"},
         {"field",
          {field("image", "sc:ImageObject", "image-files", "the picture"),
           field("mask", "sc:ImageObject", "mask-files", "255 where half of a pixel is crack"),
           field("width", "sc:ImageObject", "width-files",
                 "width of the crack there, 1/256 pixel")}}}}}};
  return json.dump(2) + "\n";
}

}  // namespace craze
