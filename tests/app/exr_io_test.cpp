// EXR files read back by the OpenEXR library itself.
#include "app/exr_io.h"

#include <cmath>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

#include "tests/app/scratch_folder.h"

namespace burl {
namespace {

Image<RgbF> ramp(std::size_t width, std::size_t height) {
    Image<RgbF> image(width, height);
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const float t = (float(x) + 0.3f) / float(width);
            image(x, y) = {t, t * t, float(y) / float(height)};
        }
    }
    return image;
}

Image<RgbF> read_back(const std::string& path, Imf::PixelType stored) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
    EXPECT_EQ(file.header().channels().findChannel("G")->type, stored);
    const auto width = std::size_t(window.max.x + 1), height = std::size_t(window.max.y + 1);
    Image<RgbF> image(width, height);
    char* base = reinterpret_cast<char*>(&image(0, 0));
    Imf::FrameBuffer frame;
    const char* names[] = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        frame.insert(names[c],
                     Imf::Slice(Imf::FLOAT, base + 4 * c, sizeof(RgbF), sizeof(RgbF) * width));
    }
    file.setFrameBuffer(frame);
    file.readPixels(0, int(height) - 1);
    return image;
}

TEST(Exr, FloatComesBackBitForBit) {
    const ScratchFolder folder;
    const Image<RgbF> image = ramp(37, 21);
    write_exr(folder / "a.exr", image, ExrDepth::float_full);
    EXPECT_EQ(read_back(folder / "a.exr", Imf::FLOAT), image);
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Exr, HalfIsWithinItsPrecision) {
    const ScratchFolder folder;
    const Image<RgbF> image = ramp(37, 21);
    write_exr(folder / "a.exr", image);
    const Image<RgbF> back = read_back(folder / "a.exr", Imf::HALF);
    ASSERT_EQ(back.width(), image.width());
    ASSERT_EQ(back.height(), image.height());
    for (std::size_t y = 0; y < 21; ++y) {
        for (std::size_t x = 0; x < 37; ++x) {
            const float tolerance = std::ldexp(1.0f, -11);
            EXPECT_NEAR(back(x, y).r, image(x, y).r, image(x, y).r * tolerance);
            EXPECT_NEAR(back(x, y).g, image(x, y).g, image(x, y).g * tolerance + 1e-7f);
            EXPECT_NEAR(back(x, y).b, image(x, y).b, image(x, y).b * tolerance);
        }
    }
}

}  // namespace
}  // namespace burl
