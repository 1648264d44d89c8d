#include "craze/io/files/hash_file.h"

#include <fstream>
#include <string_view>

#include "craze/io/bytes/sha256.h"

namespace craze {

std::string sha256_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string part(std::size_t{1} << 20, '\0');
  Sha256 hash;
  while (file.read(part.data(), static_cast<std::streamsize>(part.size())), file.gcount() > 0) {
    hash.add(std::string_view(part).substr(0, static_cast<std::size_t>(file.gcount())));
  }
  return hash.hex();
}

}  // namespace craze
