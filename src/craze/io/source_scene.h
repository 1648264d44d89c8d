// What a file holds besides the surface that is read from it.
#pragma once

#include <string>
#include <vector>

namespace craze {

/// Things of one kind in a file, such as its animations.
struct SceneContent {
  std::string kind;                ///< plural, as a sentence says it: "animations"
  std::vector<std::string> names;  ///< one each, in the file's order; "" for one without
  bool tells_names = false;        ///< sentences say them, and not how many there are
};

/// What an object of the mesh that was read is called besides.
struct OtherName {
  std::string name;    ///< which others may have as well
  std::string object;  ///< its own
};

/// A file as it stood, for whoever writes its surface again. What is in it is the format's own
/// matter: writers ask for the type that they know. Immutable.
class SourceScene {
 public:
  virtual ~SourceScene() = default;
  /// Kinds of which there is at least one thing, in a fixed order.
  virtual std::vector<SceneContent> contents() const = 0;
  /// Bits of each channel of the colours of vertices: 8, 16, or 32 for fractions; 0: not said.
  virtual int color_bits() const { return 0; }
  /// In no certain order.
  virtual std::vector<OtherName> other_names() const { return {}; }
};

/// One sentence that names, with their numbers, the kinds of things that are not among `kept`;
/// empty where there are none. `format` stands for what cannot hold them.
std::string describe_lost(const std::vector<SceneContent>& contents,
                          const std::vector<std::string>& kept, const std::string& format);

}  // namespace craze
