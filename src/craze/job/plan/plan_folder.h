// The folder that a plan's files go to, which several processes may fill and any may resume.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "craze/context.h"
#include "craze/job/plan/plan.h"

namespace craze {

/// Where a plan came from; its mesh files are named from there.
struct PlanSource {
  std::string text;
  std::string name;              ///< what errors call it
  std::filesystem::path folder;  ///< absolute
};

/// A plan's file. Throws Error(input) where it cannot be read.
PlanSource read_plan_file(const std::filesystem::path& path);

/// The plan that is to fill a folder, or go on with it. The folder's own plan.toml is seen from
/// where it first lay, so that the folder alone is enough. Throws Error(input), also for a folder
/// that holds something else than that kind.
PlanSource read_plan_for(const std::filesystem::path& folder, const std::filesystem::path& path,
                         const std::string& kind);

/// The plan's file of a folder, where there is one.
std::optional<PlanSource> plan_there(const std::filesystem::path& folder);

/// Whether a plan goes on where the one of a folder ends, which has another text. May throw Error.
using GoesOn = std::function<bool(const PlanSource& there)>;

/// Makes the folder and writes plan.toml and made_by.json, which say what it holds and which
/// version made it. Where it holds a plan that this one goes on from, this takes its place. Throws
/// Error(usage) where it holds another plan, or was made by another version, whose files these
/// could not be told from; Error(output) where it cannot be written.
void claim_plan_folder(const std::filesystem::path& folder, const PlanSource& source,
                       const std::string& kind, const GoesOn& goes_on, const Context& context);

/// Throws Error(usage) where the folder's plan is no longer this one, as another process has
/// claimed it meanwhile.
void check_claim(const std::filesystem::path& folder, const PlanSource& source);

/// The plan that a folder was made by. Throws Error(input) where it holds nothing of that kind.
PlanSource plan_of_folder(const std::filesystem::path& folder, const std::string& kind);

}  // namespace craze
