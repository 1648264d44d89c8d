// A whole run in memory: a surface and a recipe in, a cracked surface out. No file is opened.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "craze/context.h"
#include "craze/grey_image.h"
#include "craze/opened_piece.h"
#include "craze/recipe.h"
#include "craze/report.h"
#include "craze/surface_mesh.h"

namespace craze {

/// What a run works on.
struct Input {
  /// In any state; it is repaired (mesh/repair.h). Shared, not copied, and let go once it is read.
  std::shared_ptr<const SurfaceMesh> surface;
  Textures textures;  ///< the pictures that the recipe names
  std::string name;   ///< what messages call the surface: a file, a shape
};

enum class OnCancel {
  keep,     ///< what has cracked by then is the result
  discard,  ///< crack() throws Cancelled
};

struct CrackOptions {
  /// Crack events to stop after; unlike evolution.max_cracks, 0 means none: the initial state.
  std::optional<std::int64_t> max_cracks;
  OnCancel on_cancel = OnCancel::keep;
  OnOpened on_opened = {};  ///< told of each piece of crack when it has opened
};

struct CrackedSurface;

/// A finished run. Immutable and cheap to copy; copies share one state, and several threads may
/// make products (products/) from it at a time.
class Result {
 public:
  Result(std::shared_ptr<const CrackedSurface> state, Report report)
      : state_(std::move(state)), report_(std::move(report)) {}

  /// What products are made from (engine/cracked_surface.h).
  const CrackedSurface& state() const { return *state_; }
  /// `output` counts the cut mesh, shut; `time.load` and `time.write` are for whoever has files.
  const Report& report() const { return report_; }
  std::shared_ptr<const CrackedSurface> shared_state() const { return state_; }

 private:
  std::shared_ptr<const CrackedSurface> state_;
  Report report_;
};

/// Repairs the surface, makes the simulation's mesh of it and cracks that by the recipe
/// (evolution.cycles, layer.rounds). The same input, recipe and options give the same result on any
/// number of threads; several calls may run at a time.
///
/// Throws Error: a surface that is none (input), a recipe that does not suit it (request). Throws
/// Cancelled where the context cancels before the first crack is sought, or at any time where
/// nothing is to be kept.
Result crack(Input input, const Recipe& recipe, const CrackOptions& options,
             const Context& context);

/// The [post] that a run was asked for, its lengths in the mesh's own unit: gap_width and
/// relative_roughness as they were, which a report has resolved.
PostParameters asked_post(const Result& result);

/// What crack() would have returned with this [post] in the recipe, byte for byte but for the
/// times. Nothing is cracked again: where the cracks' roughness is another one their lines alone
/// are made and cut anew, and else all is shared with `result`, or with `other`, which is of the
/// same run. Throws Error as crack() does of a recipe, and Cancelled.
Result with_post(const Result& result, const PostParameters& post, const Context& context,
                 const Result* other = nullptr);

}  // namespace craze
