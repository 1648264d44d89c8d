// JSON from strangers: bounded depth, and look-ups that say what is wrong.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace craze {

using Json = nlohmann::json;

/// Parses a text whose brackets are nested at most 64 deep. Throws Error(input).
Json parse_json(std::string_view text, const std::string& name);

/// Looks into a glTF document; each error names the file and the property.
class GltfJson {
 public:
  explicit GltfJson(const std::string& name) : name_(name) {}

  /// The array of that name, or an empty one.
  const Json& array(const Json& object, const char* key) const;
  /// The i-th object of the root array `list`.
  const Json& item(const Json& root, const char* list, std::size_t i) const;
  /// A whole number ≥ 0, where there is one.
  std::optional<std::size_t> index(const Json& object, const char* key) const;
  std::size_t index_or(const Json& object, const char* key, std::size_t fallback) const;
  /// Such a number itself.
  std::size_t as_index(const Json& value, const char* what) const;
  /// The extension of that name of an object, or nullptr.
  const Json* extension(const Json& object, const char* key) const;
  /// The string of that name, or "".
  std::string text(const Json& object, const char* key) const;
  /// Fills n numbers from the array of that name; false where there is none.
  bool numbers(const Json& object, const char* key, double* values, std::size_t n) const;

  [[noreturn]] void fail(const std::string& why) const;

 private:
  const std::string& name_;
};

}  // namespace craze
