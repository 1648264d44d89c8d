// The way in that everybody takes: the format told by the bytes, text in any encoding.
#include "craze/read_mesh.h"
#include "fuzz_reader.h"

namespace {

craze::SurfaceMesh read(const craze::MeshSource& source) {
  return craze::read_mesh(source.bytes, source.name + ".obj", source.files).mesh;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return craze::fuzz_reader(data, size, read);
}
