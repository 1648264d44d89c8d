// What the readers of pictures owe to any bytes: a picture of the size it says, or an Error(input).
#include <string>

#include "craze/error.h"
#include "craze/io/image/read_image.h"
#include "fuzz_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace craze;
  try {
    const Image image =
        read_image(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz");
    require(image.width > 0 && image.height > 0 && image.channels >= 1 && image.channels <= 4);
    const std::size_t numbers = static_cast<std::size_t>(image.width) *
                                static_cast<std::size_t>(image.height) *
                                static_cast<std::size_t>(image.channels);
    require(std::visit([](const auto& v) { return v.size(); }, image.values) == numbers);
  } catch (const Error& e) {
    require(e.kind() == ErrorKind::input);
    require(std::string_view(e.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
