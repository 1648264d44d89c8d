// Format: Khronos Group, "glTF 2.0 Specification", 2021, sections 3.6 and 4.
#include "craze/io/gltf/scene/scene_output.h"

#include <algorithm>
#include <limits>

#include "craze/error.h"
#include "craze/io/bytes/byte_order.h"
#include "craze/io/gltf/glb_file.h"
#include "craze/io/gltf/scene/accessor_places.h"

namespace craze {

namespace {

constexpr int array_buffer = 34962, element_array_buffer = 34963;

const char* type_name(std::size_t components) {
  constexpr const char* names[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  return components == 16 ? "MAT4" : components == 9 ? "MAT3" : names[components - 1];
}

/// The list of that name; made where there is none.
Json& list(Json& root, const char* name) {
  if (!root.contains(name)) root[name] = Json::array();
  return root[name];
}

std::size_t size_of(const Json& root, const char* name) {
  const auto found = root.find(name);
  return found == root.end() ? 0 : found->size();
}

/// As glTF wants bounds: of the numbers as they are stored.
void set_bounds(Json& accessor, const GltfElements& elements) {
  GltfElements stored = elements;
  stored.normalized = false;
  Json low = Json::array(), high = Json::array();
  for (std::size_t k = 0; k < stored.components; ++k) {
    double least = std::numeric_limits<double>::max(), most = -least;
    for (std::size_t i = 0; i < stored.count; ++i) {
      least = std::min(least, stored.value(i, k));
      most = std::max(most, stored.value(i, k));
    }
    low.push_back(least);
    high.push_back(most);
  }
  accessor["min"] = std::move(low);
  accessor["max"] = std::move(high);
}

std::vector<std::size_t> count_uses(Json& root, std::size_t size, auto&& for_each) {
  std::vector<std::size_t> uses(size, 0);
  for_each(root, [&](const Json& number) {
    const auto at = number.get<double>();
    if (at >= 0 && at < static_cast<double>(size)) ++uses[static_cast<std::size_t>(at)];
  });
  return uses;
}

std::vector<std::size_t> view_uses(Json& root, std::size_t size) {
  return count_uses(root, size, [](Json& json, auto&& v) { for_each_view_place(json, v); });
}

/// Without overlaps, by begin.
template <class Range>
std::vector<Range> merged(std::vector<Range> ranges) {
  std::sort(ranges.begin(), ranges.end(),
            [](const Range& a, const Range& b) { return a.begin < b.begin; });
  std::vector<Range> result;
  for (const Range& range : ranges) {
    if (!result.empty() && range.begin <= result.back().end) {
      result.back().end = std::max(result.back().end, range.end);
    } else {
      result.push_back(range);
    }
  }
  return result;
}

/// Those that were in use and are no more.
std::vector<std::size_t> fallen_out(const std::vector<std::size_t>& before,
                                    const std::vector<std::size_t>& after) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] > 0 && after[i] == 0) out.push_back(i);
  }
  return out;
}

/// Where each added item goes: into the freed places first, then behind the old ones.
std::vector<std::size_t> new_places(std::size_t old, std::size_t added,
                                    const std::vector<std::size_t>& freed) {
  std::vector<std::size_t> places(added);
  for (std::size_t i = 0; i < added; ++i) {
    places[i] = i < freed.size() ? freed[i] : old + i - freed.size();
  }
  return places;
}

/// Moves the items behind `old` to their places.
void move_items(Json& items, std::size_t old, const std::vector<std::size_t>& places) {
  Json moved = Json::array();
  for (std::size_t i = 0; i < old; ++i) moved.push_back(std::move(items[i]));
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i] >= moved.size()) moved.push_back(Json());
    moved[places[i]] = std::move(items[old + i]);
  }
  items = std::move(moved);
}

void renumber(Json& number, std::size_t old, const std::vector<std::size_t>& places) {
  const auto at = number.get<std::size_t>();
  if (at >= old) number = places[at - old];
}

}  // namespace

SceneOutput::SceneOutput(const GltfDocument& document)
    : root(document.root()),
      document_(document),
      old_accessors_(size_of(root, "accessors")),
      old_views_(size_of(root, "bufferViews")) {
  accessor_uses_before_ = accessor_uses();
  view_uses_before_ = view_uses(root, old_views_);
}

std::vector<std::size_t> SceneOutput::accessor_uses() {
  return count_uses(root, old_accessors_,
                    [](Json& json, auto&& v) { for_each_accessor_place(json, v); });
}

std::size_t SceneOutput::add_view(const std::string& bytes, Use use, std::size_t stride) {
  Json view{{"buffer", 0}, {"byteLength", bytes.size()}};
  if (stride > 0) view["byteStride"] = stride;
  if (use == Use::vertices) view["target"] = array_buffer;
  if (use == Use::indices) view["target"] = element_array_buffer;
  added_bytes_.push_back(bytes);
  list(root, "bufferViews").push_back(std::move(view));
  return root["bufferViews"].size() - 1;
}

std::size_t SceneOutput::add_accessor(Json accessor, const GltfElements& elements,
                                      const Json* like) {
  accessor["componentType"] = elements.component_type;
  accessor["count"] = elements.count;
  accessor["type"] = type_name(elements.components);
  if (elements.normalized) accessor["normalized"] = true;
  if (like) {
    // Four numbers may be a matrix.
    if (elements.components == 4 && like->value("type", "") == "MAT2") accessor["type"] = "MAT2";
    for (const char* key : {"name", "extras"}) {
      if (like->contains(key)) accessor[key] = (*like)[key];
    }
    if (like->contains("min") || like->contains("max")) set_bounds(accessor, elements);
  }
  list(root, "accessors").push_back(std::move(accessor));
  return root["accessors"].size() - 1;
}

std::size_t SceneOutput::add(const GltfElements& elements, Use use, const Json* like) {
  const std::size_t size = elements.size(), stride = (size + 3) / 4 * 4;
  if (use != Use::vertices || stride == size) {
    return add_accessor({{"bufferView", add_view(elements.bytes, use, 0)}}, elements, like);
  }
  std::string spaced;
  for (std::size_t i = 0; i < elements.count; ++i) {
    spaced += elements.bytes.substr(i * size, size);
    spaced.append(stride - size, '\0');
  }
  return add_accessor({{"bufferView", add_view(spaced, use, stride)}}, elements, like);
}

std::size_t SceneOutput::add_sparse(const GltfElements& elements, const Json* like) {
  const std::size_t size = elements.size();
  std::string indices, values;
  std::size_t count = 0;
  for (std::size_t i = 0; i < elements.count; ++i) {
    const std::string_view element = std::string_view(elements.bytes).substr(i * size, size);
    if (element.find_first_not_of('\0') == std::string_view::npos) continue;
    append(indices, static_cast<std::uint32_t>(i));
    values += element;
    ++count;
  }
  Json accessor = Json::object();
  if (count > 0) {
    accessor["sparse"] = {
        {"count", count},
        {"indices", {{"bufferView", add_view(indices, Use::plain, 0)}, {"componentType", 5125}}},
        {"values", {{"bufferView", add_view(values, Use::plain, 0)}}}};
  }
  return add_accessor(std::move(accessor), elements, like);
}

std::size_t SceneOutput::add_indices(const std::vector<std::uint32_t>& indices,
                                     std::size_t vertices, std::size_t least) {
  // The highest number of a type stands for none.
  std::size_t type = std::max<std::size_t>(least, 5121);
  if (type == 5121 && vertices > 255) type = 5123;
  if (type == 5123 && vertices > 65535) type = 5125;
  GltfElements elements;
  elements.component_type = type;
  for (const std::uint32_t i : indices) {
    const double value = i;
    elements.append(&value);
  }
  return add(elements, Use::indices);
}

void SceneOutput::forget_extension(const char* name) {
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
    if (!root.contains(list)) continue;
    Json kept = Json::array();
    for (const Json& used : root[list]) {
      if (used != Json(name)) kept.push_back(used);
    }
    if (kept.empty()) {
      root.erase(list);
    } else {
      root[list] = std::move(kept);
    }
  }
}

void SceneOutput::use_extension(const char* name) {
  Json& used = list(root, "extensionsUsed");
  if (std::find(used.begin(), used.end(), Json(name)) == used.end()) used.push_back(name);
}

void SceneOutput::reuse_accessors() {
  const std::size_t added = size_of(root, "accessors") - old_accessors_;
  const auto places =
      new_places(old_accessors_, added, fallen_out(accessor_uses_before_, accessor_uses()));
  for_each_accessor_place(root, [&](Json& number) { renumber(number, old_accessors_, places); });
  if (added > 0) move_items(root["accessors"], old_accessors_, places);
}

/// Bytes of views out of use that no other view shares, in whole units of the alignment, so that
/// whatever follows stays aligned.
std::vector<SceneOutput::Range> SceneOutput::unused_ranges(
    const std::vector<std::size_t>& freed) const {
  std::vector<Range> unused, kept;
  for (std::size_t v = 0; v < old_views_; ++v) {
    const Json& view = root["bufferViews"][v];
    const std::size_t begin = view.value("byteOffset", std::size_t{0});
    const bool is_freed = std::binary_search(freed.begin(), freed.end(), v);
    (is_freed ? unused : kept).push_back({begin, begin + view.value("byteLength", std::size_t{0})});
  }
  kept = merged(std::move(kept));
  std::vector<Range> result;
  auto k = kept.begin();
  for (const Range& range : merged(std::move(unused))) {
    std::size_t at = range.begin;
    const auto add_up_to = [&](std::size_t end) {
      const std::size_t from = aligned(at);
      const std::size_t to = end / element_alignment * element_alignment;
      if (from < to) result.push_back({from, to});
    };
    while (k != kept.end() && k->end <= range.begin) ++k;
    for (auto inside = k; inside != kept.end() && inside->begin < range.end; ++inside) {
      add_up_to(inside->begin);
      at = inside->end;
    }
    add_up_to(range.end);
  }
  return result;
}

std::string SceneOutput::bytes_without(const std::vector<Range>& unused) {
  std::string bytes;
  std::size_t at = 0;
  for (const Range& range : unused) {
    bytes += document_.bin().substr(at, range.begin - at);
    at = range.end;
  }
  bytes += document_.bin().substr(at);
  return bytes;
}

void SceneOutput::reuse_views() {
  const std::vector<std::size_t> freed = fallen_out(view_uses_before_, view_uses(root, old_views_));
  const std::vector<Range> unused = unused_ranges(freed);
  std::string bytes = bytes_without(unused);
  if (size_of(root, "bufferViews") == 0) return;
  Json& views = root["bufferViews"];
  std::vector<std::size_t> gone{0};  // bytes that the first ranges take
  for (const Range& range : unused) gone.push_back(gone.back() + range.end - range.begin);
  for (std::size_t v = 0; v < old_views_; ++v) {
    const std::size_t begin = views[v].value("byteOffset", std::size_t{0});
    const auto before =
        std::upper_bound(unused.begin(), unused.end(), begin,
                         [](std::size_t at, const Range& range) { return at < range.end; });
    const std::size_t shift = gone[static_cast<std::size_t>(before - unused.begin())];
    if (shift > 0) views[v]["byteOffset"] = begin - shift;
  }
  for (std::size_t i = 0; i < added_bytes_.size(); ++i) {
    bytes.resize(aligned(bytes.size()), '\0');
    views[old_views_ + i]["byteOffset"] = bytes.size();
    bytes += added_bytes_[i];
  }
  const auto places = new_places(old_views_, added_bytes_.size(), freed);
  for_each_view_place(root, [&](Json& number) { renumber(number, old_views_, places); });
  move_items(views, old_views_, places);
  // A place that nothing came into still has to be a view of something.
  for (std::size_t i = added_bytes_.size(); i < freed.size(); ++i) {
    views[freed[i]]["byteOffset"] = 0;
    views[freed[i]]["byteLength"] = 1;
    views[freed[i]].erase("byteStride");
  }
  if (!root.contains("buffers")) root["buffers"] = Json::array({Json::object()});
  root["buffers"][0]["byteLength"] = bytes.size();
  added_bytes_ = {std::move(bytes)};
}

SceneOutput::Parts SceneOutput::finish() {
  reuse_accessors();
  reuse_views();
  return {std::move(root), added_bytes_.empty() ? document_.bin() : std::move(added_bytes_[0])};
}

std::string SceneOutput::pack() {
  const Parts parts = finish();
  return glb_file(parts.root.dump(-1, ' ', false, Json::error_handler_t::replace), parts.bin);
}

}  // namespace craze
