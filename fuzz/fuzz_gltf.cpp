#include "craze/io/gltf/gltf.h"
#include "fuzz_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return craze::fuzz_reader(data, size, craze::read_gltf);
}
