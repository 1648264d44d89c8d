// What is written, as OpenEXR's own library reads it.
#if defined CRAZE_OPENEXR && defined CRAZE_PNG  // zlib comes with libpng
#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <gtest/gtest.h>

#include "craze/io/image/row_image.h"
#include "temporary_folder.h"

namespace craze {
namespace {

TEST(OpenExr, ReadsTheNumbersThatWereWritten) {
  const TemporaryFolder folder;
  const Context context;
  const int width = 37, height = 50;
  for (const int channels : {1, 3}) {
    std::vector<float> values;
    for (int i = 0; i < width * height * channels; ++i) {
      values.push_back(i % 11 == 0 ? -1e6f * static_cast<float>(i) : static_cast<float>(i) / 7);
    }
    const std::string path = (folder / "map.exr").string();
    const auto image = new_exr(path, {width, height, channels}, context);
    for (int first = 0; first < height; first += image->block_rows()) {
      const int count = std::min(image->block_rows(), height - first);
      const float* rows = values.data() + static_cast<std::size_t>(first) * width * channels;
      image->write(first, image->pack(first, count, rows));
    }
    image->finish();

    Imf::InputFile file(path.c_str());
    EXPECT_TRUE(file.isComplete());
    const char* const names[] = {channels == 1 ? "Y" : "R", "G", "B"};
    Imf::FrameBuffer buffer;
    std::vector<float> read(values.size());
    const std::size_t pixel = sizeof(float) * static_cast<std::size_t>(channels);
    for (int c = 0; c < channels; ++c) {
      ASSERT_NE(file.header().channels().findChannel(names[c]), nullptr);
      buffer.insert(names[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(read.data() + c),
                                         pixel, pixel * width));
    }
    file.setFrameBuffer(buffer);
    file.readPixels(0, height - 1);
    EXPECT_EQ(read, values);
  }
}

}  // namespace
}  // namespace craze
#endif
