// A document that is written again: what is added to it, and what it no longer needs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "craze/io/gltf/gltf_elements.h"
#include "craze/io/gltf/gltf_json.h"
#include "craze/io/gltf/scene/gltf_document.h"

namespace craze {

/// Views and accessors are only added while the document is being changed; pack() puts them in the
/// places of those that have fallen out of use, so that whatever else counts views or accessors,
/// known here or not, still finds its own.
class SceneOutput {
 public:
  enum class Use { plain, vertices, indices };  ///< what a view is bound to

  /// `document` must outlive this.
  explicit SceneOutput(const GltfDocument& document);

  Json root;  ///< the document, to be changed

  /// An accessor of the document as it stood, or one that was added.
  const Json& accessor(std::size_t number) const { return root["accessors"][number]; }
  /// An accessor of these elements. like: the accessor whose name, extras and bounds it takes over
  /// (the bounds anew), or null.
  std::size_t add(const GltfElements& elements, Use use, const Json* like = nullptr);
  /// The same for vectors most of which are zero, which are not stored.
  std::size_t add_sparse(const GltfElements& elements, const Json* like = nullptr);
  /// Indices of the narrowest type that is not below `least` (a componentType).
  std::size_t add_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices,
                          std::size_t least);
  /// A view of any bytes, such as a picture's.
  std::size_t add_bytes(const std::string& bytes) { return add_view(bytes, Use::plain, 0); }
  /// Names an extension among those used.
  void use_extension(const char* name);
  /// Names it among them no more.
  void forget_extension(const char* name);

  struct Parts {
    Json root;
    std::string bin;  ///< its one buffer
  };
  /// The document, changed; this is of no use after.
  Parts finish();
  /// The same as a file. Throws Error(request) for more than 4 GB.
  std::string pack();

 private:
  struct Range {
    std::size_t begin, end;
  };
  std::size_t add_view(const std::string& bytes, Use use, std::size_t stride);
  std::size_t add_accessor(Json accessor, const GltfElements& elements, const Json* like);
  std::vector<std::size_t> accessor_uses();
  void reuse_accessors();
  void reuse_views();
  std::vector<Range> unused_ranges(const std::vector<std::size_t>& freed) const;
  /// The old ones.
  std::string bytes_without(const std::vector<Range>& unused);

  const GltfDocument& document_;
  std::size_t old_accessors_, old_views_;
  std::vector<std::size_t> accessor_uses_before_, view_uses_before_;
  std::vector<std::string> added_bytes_;  ///< by view beyond the old ones
};

}  // namespace craze
