#include "craze/io/gltf/gltf.h"
#include "fuzz_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return craze::fuzz_reader(data, size, [](std::string_view bytes, const std::string& name) {
    return craze::read_gltf(bytes, name);  // no loader: no file is opened
  });
}
