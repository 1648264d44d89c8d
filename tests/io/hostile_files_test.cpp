// Files made to hurt. Each must end in an Error(input) of one line, soon, without much memory.

#include <chrono>

#include "craze/base/text/format.h"
#include "craze/io/bytes/byte_order.h"
#include "craze/io/gltf/gltf.h"
#include "craze/io/obj/obj.h"
#include "craze/io/off/off.h"
#include "craze/io/ply/ply.h"
#include "craze/io/stl/stl.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

using Reader = SurfaceMesh (*)(const MeshSource&);

struct Hostile {
  const char* name;
  Reader read;
  std::string bytes;
  const char* says;  ///< a part of the message
};

void PrintTo(const Hostile& h, std::ostream* out) {
  *out << h.name;
}

std::string repeat(std::string_view text, std::size_t times) {
  std::string result;
  result.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) result += text;
  return result;
}

const std::string triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string indices = "property list uchar int vertex_indices\n";

std::string ply(const std::string& format, const std::string& vertices, const std::string& faces,
                const std::string& body) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + vertices + "\n" + xyz +
         "element face " + faces + "\n" + indices + "end_header\n" + body;
}

/// A zigzag whose every other corner is reflex, with one vertex index per corner.
std::string comb_obj(int teeth) {
  std::string text;
  for (int i = 0; i < teeth; ++i) text += fmt::format("v {} {} 0\n", i, i % 2);
  text += "v 0 9 0\nf";
  for (int i = 1; i <= teeth + 1; ++i) text += fmt::format(" {}", i);
  return text + "\n";
}

std::string stl_header(std::uint32_t count) {
  std::string bytes(80, '\0');
  append(bytes, count);
  return bytes;
}

/// A glTF file whose root has these members besides its asset.
std::string gltf(const std::string& members) {
  return R"({"asset":{"version":"2.0"},)" + members + "}";
}

/// One triangle in a data URI, with an accessor to be replaced.
std::string gltf_accessor(const std::string& accessor) {
  return gltf(R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[)" +
              accessor +
              R"(],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":)"
              R"("data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}])");
}

std::string many_instances(int nodes) {
  std::string list = R"({"mesh":0})";
  list += repeat(R"(,{"mesh":0})", static_cast<std::size_t>(nodes - 1));
  std::string primitive = R"({"attributes":{"POSITION":0}})";
  return gltf(R"("nodes":[)" + list + R"(],"meshes":[{"primitives":[)" + primitive +
              repeat("," + primitive, 999) +
              R"(]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
              R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":)"
              R"("data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}])");
}

std::string many_attributes(std::size_t count) {
  std::string attributes = R"("POSITION":0)";
  for (std::size_t i = 0; i < count; ++i) attributes += fmt::format(",\"_A{}\":0", i);
  const std::string data = repeat("AAAA", 30000);
  return gltf(R"("meshes":[{"primitives":[{"attributes":{)" + attributes +
              R"(}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":7500,)"
              R"("type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":90000}],)"
              R"("buffers":[{"byteLength":90000,"uri":"data:;base64,)" +
              data + R"("}])");
}

std::string glb(std::uint32_t json_size, const std::string& rest) {
  std::string bytes = "glTF";
  append(bytes, std::uint32_t{2});
  append(bytes, std::uint32_t{20});
  append(bytes, json_size);
  return bytes + "JSON" + rest;
}

std::vector<Hostile> hostile_files() {
  std::vector<Hostile> files = {
      {"obj_empty", read_obj, "", "no triangles"},
      {"obj_only_points", read_obj, triangle_obj, "no triangles"},
      {"obj_index_zero", read_obj, triangle_obj + "f 0 1 2\n", "a.file:4"},
      {"obj_index_too_large", read_obj, triangle_obj + "f 1 2 4\n",
       "a.file:4): a corner asks for vertex 4 of 3"},
      {"obj_index_too_negative", read_obj, triangle_obj + "f -1 -2 -4\n", "a.file:4"},
      {"obj_index_beyond_64_bits", read_obj, triangle_obj + "f 1 2 99999999999999999999\n",
       "a.file:4"},
      {"obj_index_beyond_32_bits", read_obj, triangle_obj + "f 1 2 4294967297\n", "a.file:4"},
      {"obj_nan", read_obj, "v 0 nan 0\n", "a.file:1): a coordinate 'nan' is not a finite number"},
      {"obj_infinity", read_obj, "v 0 0 0\nv 1e999 0 0\n", "a.file:2"},
      {"obj_missing_coordinate", read_obj, "v 1 2\n", "missing"},
      {"obj_word_for_a_number", read_obj, "v 1 2 abc\x1b[31m\n", "'abc?[31m'"},
      {"obj_corner_of_four_parts", read_obj, triangle_obj + "f 1/1/1/1 2 3\n", "V/VT/VN"},
      {"obj_nothing_but_slashes", read_obj, triangle_obj + "f / // ///\n", "a.file:4"},
      {"obj_half_a_continuation", read_obj, triangle_obj + "f 1 2 \\", "a.file:4"},
      {"obj_zero_bytes", read_obj, std::string(1000, '\0'), "no triangles"},
      {"obj_many_corners_that_are_not_convex", read_obj, comb_obj(200000), "not convex"},
      {"obj_one_endless_number", read_obj, "v " + std::string(4'000'000, '1') + " 0 0\n", "finite"},
  };
  const auto add = [&](const char* name, Reader read, std::string bytes, const char* says) {
    files.push_back({name, read, std::move(bytes), says});
  };
  add("ply_wrong_magic", read_ply, "plx\n", "'ply'");
  add("ply_empty", read_ply, "", "'ply'");
  add("ply_no_end_header", read_ply, "ply\nformat ascii 1.0\n", "end_header");
  add("ply_no_format", read_ply, "ply\nend_header\n", "format");
  add("ply_unknown_format", read_ply, "ply\nformat binary_middle_endian 1.0\n", "a.file:2");
  add("ply_property_twice", read_ply,
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float x\nend_header\n",
      "'vertex' has the property 'x' twice");
  add("ply_index_below_zero", read_ply, ply("ascii", "3", "1", "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"),
      "a corner's index is none of 0 to 2");
  add("gltf_needs_a_newer_version", read_gltf, R"({"asset":{"version":"2.1","minVersion":"2.1"}})",
      "it needs glTF version 2.1");
  add("ply_property_before_element", read_ply, "ply\nformat ascii 1.0\nproperty int x\n",
      "a.file:3");
  add("ply_unknown_type", read_ply, "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n",
      "'quad'");
  add("ply_negative_count", read_ply, "ply\nformat ascii 1.0\nelement vertex -1\n", "negative");
  add("ply_huge_ascii_count", read_ply, ply("ascii", "4000000000", "1", "0 0 0\n"), "too short");
  add("ply_huge_binary_count", read_ply,
      ply("binary_little_endian", "9223372036854775807", "1", "0000"), "too short");
  add("ply_huge_count_without_properties", read_ply,
      "ply\nformat ascii 1.0\nelement vertex 9223372036854775807\nelement face "
      "9223372036854775807\nend_header\n",
      "lack");
  add("ply_truncated_rows", read_ply, ply("binary_little_endian", "3", "1", std::string(35, '\0')),
      "too short");
  add("ply_truncated_list", read_ply,
      ply("binary_little_endian", "3", "1", std::string(36, '\0') + "\xff"), "too short");
  add("ply_list_of_four_billion", read_ply,
      "ply\nformat binary_little_endian 1.0\nelement vertex 0\n" + xyz +
          "element face 1\nproperty list uint double vertex_indices\nend_header\n\xff\xff\xff\xff",
      "too short");
  add("ply_negative_list_length", read_ply,
      "ply\nformat binary_little_endian 1.0\nelement vertex 0\n" + xyz +
          "element face 1\nproperty list char int vertex_indices\nend_header\n\xff",
      "negative length");
  add("ply_float_list_length", read_ply,
      "ply\nformat ascii 1.0\nelement face 1\nproperty list float int vertex_indices\n", "float");
  add("ply_ascii_list_too_long", read_ply,
      ply("ascii", "3", "1", "0 0 0\n1 0 0\n0 1 0\n999999999 0 1 2\n"), "too short");
  add("ply_index_out_of_range", read_ply, ply("ascii", "3", "1", "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
      "face 0");
  add("ply_negative_index", read_ply, ply("ascii", "3", "1", "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"),
      "face 0");
  add("ply_nan_coordinate", read_ply,
      ply("binary_little_endian", "3", "1",
          std::string(12, '\0') + std::string("\0\0\xc0\x7f", 4) + std::string(40, '\0')),
      "vertex 1: x");
  add("ply_no_coordinates", read_ply,
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float q\nelement face 0\n" + indices +
          "end_header\n1\n",
      "lack x, y or z");
  add("ply_no_faces", read_ply, ply("ascii", "1", "0", "0 0 0\n"), "no triangles");
  add("ply_two_vertex_elements", read_ply,
      "ply\nformat ascii 1.0\nelement vertex 1\n" + xyz + "element vertex 1\n" + xyz +
          "end_header\n0 0 0\n0 0 0\n",
      "two");
  add("ply_ten_thousand_properties", read_ply,
      "ply\nformat ascii 1.0\nelement vertex 1\n" + repeat("property uchar a\n", 10000),
      "too many");
  add("ply_short_texcoord", read_ply,
      "ply\nformat ascii 1.0\nelement vertex 1\n" + xyz + "element face 1\n" + indices +
          "property list uchar float texcoord\nend_header\n0 0 0\n3 0 0 0 2 0 0\n",
      "texcoord");
  add("ply_material_out_of_range", read_ply,
      "ply\nformat ascii 1.0\ncomment material a\nelement vertex 1\n" + xyz + "element face 1\n" +
          indices + "property int material_index\nend_header\n0 0 0\n3 0 0 0 1\n",
      "material_index");
  add("stl_empty", read_stl, "", "neither");
  add("stl_short", read_stl, "STL", "neither");
  add("stl_huge_count", read_stl, stl_header(0xffffffffu),
      "promises 4294967295 triangles but holds 0");
  add("stl_truncated", read_stl, stl_header(2) + std::string(60, '\0'), "holds 1");
  add("stl_no_triangles", read_stl, stl_header(0), "no triangles");
  add("stl_ascii_without_triangles", read_stl, "solid a\nendsolid a\n", "no triangles");
  add("stl_ascii_cut_short", read_stl,
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n", "within a facet");
  add("stl_ascii_four_corners", read_stl,
      "solid\nouter loop\n" + repeat("vertex 0 0 0\n", 4) + "endloop\n", "4 vertices");
  add("stl_ascii_nan", read_stl, "solid\nouter loop\nvertex nan 0 0\n", "a.file:3");
  add("stl_ascii_garbage", read_stl, "solid\n\x01\x02\x03", "not a word of STL");
  add("stl_nan", read_stl,
      stl_header(1) + std::string(12, '\0') + std::string("\0\0\xc0\x7f", 4) +
          std::string(34, '\0'),
      "triangle 0");
  add("off_empty", read_off, "", "'OFF'");
  add("off_wrong_magic", read_off, "FOO\n", "'OFF'");
  add("off_huge_counts", read_off, "OFF\n2000000000 2000000000 0\n0 0 0\n",
      "more than the file can hold");
  add("off_negative_count", read_off, "OFF\n-3 1 0\n", "negative");
  add("off_truncated_vertices", read_off, "OFF\n3 1 0\n0.0000 0.0000 0.0000\n",
      "ends after 1 of 3 vertices");
  add("off_truncated_faces", read_off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n",
      "ends after 0 of 1 faces");
  add("off_index_out_of_range", read_off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
      "vertex 3 of 3");
  add("off_huge_face", read_off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n", "missing");
  add("off_nan", read_off, "OFF\n3 1 0\n0 0 inf\n", "a.file:3");
  add("off_no_faces", read_off, "OFF\n1 0 0\n0 0 0\n", "no triangles");
  add("gltf_empty", read_gltf, "", "JSON is broken");
  add("gltf_not_an_object", read_gltf, "[1,2]", "version 2");
  add("gltf_version_1", read_gltf, R"({"asset":{"version":"1.0"}})", "version 2");
  add("gltf_nested_a_million_deep", read_gltf, std::string(1'000'000, '['), "nested");
  add("gltf_objects_nested_deep", read_gltf, repeat("{\"a\":", 100'000), "nested");
  add("gltf_huge_number", read_gltf, gltf(R"("scene":1e999)"), "number");
  add("gltf_without_meshes", read_gltf, gltf(R"("scene":0)"), "no triangles");
  add("gltf_scene_missing", read_gltf, gltf(R"("scene":5,"scenes":[{}],"nodes":[{}])"), "'scenes'");
  add("gltf_scene_of_wrong_type", read_gltf, gltf(R"("scenes":{"a":1},"nodes":[])"),
      "not an array");
  add("gltf_node_cycle", read_gltf,
      gltf(R"("scenes":[{"nodes":[0]}],"nodes":[{"children":[1]},{"children":[0]}])"), "ancestor");
  add("gltf_nodes_that_multiply", read_gltf,
      gltf(R"("scenes":[{"nodes":[0]}],"nodes":[{"children":[1,1]},{"children":[2,2]},{}])"),
      "two ways");
  add("gltf_node_out_of_range", read_gltf, gltf(R"("scenes":[{"nodes":[9]}],"nodes":[{}])"),
      "item 9");
  add("gltf_negative_node", read_gltf, gltf(R"("scenes":[{"nodes":[-1]}],"nodes":[{}])"),
      "whole number");
  add("gltf_matrix_of_nine", read_gltf, gltf(R"("nodes":[{"matrix":[1,0,0,0,1,0,0,0,1]}])"),
      "16 numbers");
  add("gltf_transform_overflows", read_gltf,
      gltf(R"("nodes":[{"scale":[1e300,1,1],"children":[1]},{"scale":[1e300,1,1]}])"),
      "not finite");
  add("gltf_huge_accessor", read_gltf,
      gltf_accessor(
          R"({"bufferView":0,"componentType":5126,"count":9007199254740991,"type":"VEC3"})"),
      "beyond its bufferView");
  add("gltf_accessor_without_view", read_gltf,
      gltf_accessor(R"({"componentType":5126,"count":1000000000,"type":"VEC3"})"),
      "1000000000 zeros");
  add("gltf_accessor_offset_wraps", read_gltf,
      gltf_accessor(
          R"({"bufferView":0,"byteOffset":9007199254740990,"componentType":5126,"count":3,"type":"VEC3"})"),
      "beyond");
  add("gltf_accessor_of_unknown_type", read_gltf,
      gltf_accessor(R"({"bufferView":0,"componentType":5130,"count":3,"type":"VEC3"})"),
      "componentType");
  add("gltf_positions_of_two_components", read_gltf,
      gltf_accessor(R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC2"})"),
      "POSITION");
  add("gltf_view_beyond_buffer", read_gltf,
      gltf(
          R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
          R"("bufferViews":[{"buffer":0,"byteOffset":9007199254740991,"byteLength":36}],"buffers":[{"byteLength":3,"uri":"data:;base64,AAAA"}])"),
      "beyond its buffer");
  add("gltf_buffer_shorter_than_said", read_gltf,
      gltf(
          R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
          R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":1000000000000,"uri":"data:;base64,AAAA"}])"),
      "should have");
  add("gltf_bad_base64", read_gltf,
      gltf(
          R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
          R"("bufferViews":[{"buffer":0,"byteLength":3}],"buffers":[{"byteLength":3,"uri":"data:;base64,!!!!"}])"),
      "base64");
  add("gltf_file_without_a_loader", read_gltf,
      gltf(
          R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
          R"("bufferViews":[{"buffer":0,"byteLength":3}],"buffers":[{"byteLength":3,"uri":"/etc/passwd"}])"),
      "cannot be opened");
  add("gltf_a_million_instances", read_gltf, many_instances(10000), "instances expand");
  add("gltf_attributes_that_share_one_accessor", read_gltf, many_attributes(20000), "expand");
  add("glb_cut_in_the_header", read_gltf, "glTF\x02", "too short");
  add("glb_version_1", read_gltf, std::string("glTF\x01\0\0\0", 8) + std::string(20, '\0'),
      "version 2");
  add("glb_chunk_beyond_the_file", read_gltf, glb(0xfffffff0u, "{}  "), "within a chunk");
  add("glb_without_json", read_gltf, glb(0, ""), "JSON is broken");
  return files;
}

class HostileFiles : public testing::TestWithParam<Hostile> {};

TEST_P(HostileFiles, EndInOneLineSoon) {
  const Hostile& hostile = GetParam();
  const auto start = std::chrono::steady_clock::now();
  const std::string message = message_of([&] { read_by(hostile.read, hostile.bytes); });
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_TRUE(message.starts_with("cannot read mesh (a.file")) << message;
  EXPECT_NE(message.find(hostile.says), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_LT(seconds.count(), 5.0) << "generous, for sanitizers; a release takes milliseconds";
}

INSTANTIATE_TEST_SUITE_P(Io, HostileFiles, testing::ValuesIn(hostile_files()),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace craze
