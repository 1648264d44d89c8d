#include "craze/job/plan/plan_folder.h"

#include <nlohmann/json.hpp>

#include "craze/base/version.h"
#include "craze/error.h"
#include "craze/io/files/atomic_file.h"
#include "craze/io/files/read_file.h"
#include "craze/job/output_folder.h"
#include "craze/recipe/toml_text.h"

namespace craze {

namespace fs = std::filesystem;

namespace {

constexpr const char* plan_file = "plan.toml";
constexpr const char* origin_file = "made_by.json";

nlohmann::ordered_json origin_of(const fs::path& folder) {
  const auto json = nlohmann::ordered_json::parse(
      read_file(folder / origin_file, "cannot read what made the folder"), nullptr, false);
  bool sound = json.is_object();
  for (const char* text : {"kind", "version", "plan_folder"}) {
    sound = sound && (!json.contains(text) || json[text].is_string());
  }
  if (!sound) {
    throw Error(ErrorKind::input, "cannot read what made the folder",
                (folder / origin_file).string(), "it is damaged");
  }
  return json;
}

}  // namespace

PlanSource read_plan_file(const fs::path& path) {
  std::error_code failed;
  const auto size = fs::file_size(path, failed);
  if (!failed && size > toml_size_limit) {
    throw Error(ErrorKind::usage, "not a plan", path.string(), "larger than a mebibyte");
  }
  return {read_file(path, "cannot read the plan"), path.string(),
          fs::absolute(path).parent_path().lexically_normal()};
}

std::optional<PlanSource> plan_there(const fs::path& folder) {
  const fs::path path = folder / plan_file;
  std::error_code failed;
  if (!fs::exists(path, failed)) return std::nullopt;
  return PlanSource{read_file(path, "cannot read the plan"), path.string(), folder};
}

void claim_plan_folder(const fs::path& folder, const PlanSource& source, const std::string& kind,
                       const GoesOn& goes_on, const Context& context) {
  const nlohmann::ordered_json origin{
      {"kind", kind}, {"version", version()}, {"plan_folder", source.folder.string()}};
  const std::string origin_text = origin.dump(2) + "\n";
  if (const auto held = plan_there(folder)) {
    const bool same = held->text == source.text;
    if (fs::exists(folder / origin_file)) {
      const nlohmann::ordered_json there = origin_of(folder);
      for (const char* what : {"kind", "version"}) {
        if (there.value(what, "") == origin[what]) continue;
        throw Error(ErrorKind::usage, "the folder was made otherwise", folder.string(),
                    std::string(what) + " " + there.value(what, "unknown") + " there, " +
                        origin[what].get<std::string>() + " now; give an empty folder");
      }
      if (same) return;
    }
    if (!same && !goes_on(*held)) {
      throw Error(ErrorKind::usage, "the folder holds another plan", folder.string(),
                  "give an empty one, or the plan it was begun with");
    }
  }
  make_output_folder("the folder", folder);
  constexpr const char* failure = "cannot write the folder's plan";
  // The plan last: until it is there, a run that goes on from another does this again.
  write_file(folder / origin_file, origin_text, failure, context);
  write_file(folder / plan_file, source.text, failure, context);
}

void check_claim(const fs::path& folder, const PlanSource& source) {
  const auto held = plan_there(folder);
  if (held && held->text == source.text) return;
  throw Error(ErrorKind::usage, "the folder's plan is another one now", folder.string(),
              "another run has changed it; start again with the plan that is to be");
}

PlanSource plan_of_folder(const fs::path& folder, const std::string& kind) {
  const auto fail = [&](const std::string& why) {
    throw Error(ErrorKind::input, "no " + kind, folder.string(), why);
  };
  std::error_code failed;
  if (!fs::is_directory(folder, failed)) fail("there is no such folder");
  if (!fs::exists(folder / origin_file, failed)) fail(std::string("it has no ") + origin_file);
  const nlohmann::ordered_json origin = origin_of(folder);
  const std::string there = origin.value("kind", kind);
  if (there != kind) fail("it holds a " + there);
  return {read_file(folder / plan_file, "cannot read the plan"), (folder / plan_file).string(),
          origin.value("plan_folder", std::string("."))};
}

PlanSource read_plan_for(const fs::path& folder, const fs::path& path, const std::string& kind) {
  std::error_code failed;
  const bool own = fs::equivalent(path, folder / plan_file, failed) && !failed;
  return own ? plan_of_folder(folder, kind) : read_plan_file(path);
}

}  // namespace craze
