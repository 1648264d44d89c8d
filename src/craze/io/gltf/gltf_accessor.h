// The numbers behind a glTF accessor.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "craze/io/gltf/gltf_elements.h"
#include "craze/io/gltf/gltf_json.h"
#include "craze/io/mesh_source.h"

namespace craze {

/// Decodes accessors, sparse ones and those without data (zeros) too, bringing each buffer into
/// memory when it is first asked for. Every offset and count is checked against the buffer's size
/// before anything is allocated; zeros, which need no data, are bounded by `most`.
class GltfAccessors {
 public:
  /// All must outlive this. `bin` is GLB's binary chunk, or empty.
  GltfAccessors(const Json& root, std::string_view bin, const FileLoader& loader, std::size_t most,
                const std::string& name)
      : json_(name), root_(root), bin_(bin), loader_(loader), most_(most) {}

  struct Values {
    std::size_t count = 0;
    std::size_t components = 1;
    std::vector<double> values;  ///< count × components, finite; integers scaled if "normalized"
  };
  Values read(std::size_t accessor);
  /// The same with `instead` for numbers that are not finite.
  Values read_mended(std::size_t accessor, double instead);
  /// Accessors that had such numbers, and what stands for them.
  const std::map<std::size_t, double>& broken() const { return broken_; }
  /// The same as the file's own bytes, packed, with what a sparse accessor gives instead in place.
  GltfElements elements(std::size_t accessor);
  /// A scalar accessor of unsigned integers.
  std::vector<std::uint32_t> read_indices(std::size_t accessor);
  /// Elements of the accessor, as it says, without decoding or checking it.
  std::size_t count(std::size_t accessor) const;
  /// Whether it has data, or zeros stand for them.
  bool has_data(std::size_t accessor) const;
  /// The bytes of a buffer view, checked to lie in its buffer.
  std::string_view view(std::size_t buffer_view);
  /// A buffer's bytes, and those that a URI stands for. Valid as long as this.
  std::string_view buffer(std::size_t index);
  std::string_view source(const std::string& uri);
  /// Bytes the loader has brought so far.
  std::size_t loaded_bytes() const { return loaded_bytes_; }

 private:
  /// Elements in a row of bytes; `first` is null where zeros stand for them.
  struct Layout {
    const char* first = nullptr;
    std::size_t count = 0, components = 0, stride = 0, component_type = 0;
    bool normalized = false;
  };
  Layout layout(std::size_t accessor);
  Values read_any(std::size_t accessor);
  /// Finds the bytes of `layout` in a view; `what` for messages.
  void place(Layout& layout, std::size_t buffer_view, std::size_t offset, std::size_t stride,
             const std::string& what);
  /// Puts the elements that a sparse accessor gives instead into `out`.
  void substitute(const Json& sparse, const Layout& base, std::size_t accessor, char* out);

  GltfJson json_;
  const Json& root_;
  std::string_view bin_;
  const FileLoader& loader_;
  std::size_t most_;
  std::map<std::string, std::string> sources_;       ///< by URI: buffers may share a file
  std::map<std::size_t, std::string_view> buffers_;  ///< by index
  std::size_t loaded_bytes_ = 0;
  std::map<std::size_t, double> broken_;
};

}  // namespace craze
