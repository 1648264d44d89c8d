// What stands behind the opaque handles of craze.h.
#pragma once

#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "craze/craze.h"
#include "craze/engine.h"
#include "craze/line_set.h"
#include "craze/maps.h"
#include "craze/output/source_file.h"
#include "craze/products.h"
#include "craze/recipe.h"
#include "craze/surface_mesh.h"

struct craze_mesh {
  std::shared_ptr<const craze::SurfaceMesh> mesh;
  std::shared_ptr<const craze::SourceFile> source;  // what it was read from; null: arrays
  std::shared_ptr<const craze::Opening> opening;    // what it shows of a run; null: no run
  std::vector<std::string> warnings;                // of the file it was read from
  std::vector<std::string> names;                   // of its arrays

  explicit craze_mesh(craze::SurfaceMesh given);
  explicit craze_mesh(std::shared_ptr<const craze::SurfaceMesh> shared);

  /// Applies edit(SurfaceMesh&); those that share the mesh keep it as it was.
  template <class Edit>
  void change(Edit&& edit) {
    std::shared_ptr<craze::SurfaceMesh> changed = own_;
    if (!own_ || own_.use_count() > own_uses) {
      changed = std::make_shared<craze::SurfaceMesh>(*mesh);
    }
    // What another thread read before it let go of the mesh comes before what is written now.
    std::atomic_thread_fence(std::memory_order_acquire);
    edit(*changed);
    own_ = std::move(changed);
    mesh = own_;
    list_arrays();
  }

  /// Nothing but its arrays counts any more.
  void forget_origin() {
    source = nullptr;
    opening = nullptr;
  }

 private:
  static constexpr long own_uses = 3;  // own_, mesh and change()'s

  void list_arrays();

  std::shared_ptr<craze::SurfaceMesh> own_;  // that of `mesh`; null where it belongs to an opening
};

struct craze_lines {
  craze::LineSet lines;
};

struct craze_job {
  std::shared_ptr<const craze::SurfaceMesh> mesh;
  std::shared_ptr<const craze::SourceFile> source;  // of the mesh
  craze::Textures textures;
  craze::Recipe recipe;
  craze::CrackOptions options;
  int threads = 0;
  craze_progress progress = nullptr;
  void* user = nullptr;
  craze_opened opened = nullptr;
  void* opened_user = nullptr;
  std::optional<craze::Result> result;
  std::optional<craze::PostParameters> post;  // as asked of the result, where not of its run
  std::optional<craze::Result> rougher;  // of the same run, its cracks as rough as last asked for
  std::shared_ptr<const craze::SourceFile> cracked_source;  // of what the result was made of
};

struct craze_opening {
  std::shared_ptr<const craze::SourceFile> source;
  std::shared_ptr<const craze::Opening> opening;  // shared with the mesh made of it
  std::optional<craze::GrowthClip> clip;          // made when the first position is asked for
  std::vector<std::string> warnings;              // of the opening, and of lines made for it
};

struct craze_maps {
  std::vector<craze::Map> maps;
  std::vector<std::string> names, warnings;
  std::string description;
};
