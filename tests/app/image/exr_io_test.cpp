// EXR files read back by the OpenEXR library itself.
#include "app/image/exr_io.h"

#include <cmath>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfTiledInputFile.h>

#include "app/base/file_bytes.h"
#include "tests/app/support/scratch_folder.h"

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

Image<RgbF> in_halves(Image<RgbF> image) {
    for (std::size_t y = 0; y < image.height(); ++y)
        for (RgbF& p : image.row(y)) p = {Imath::half(p.r), Imath::half(p.g), Imath::half(p.b)};
    return image;
}

Image<RgbF> read_image(const std::string& path, Imf::PixelType type = Imf::HALF) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
    EXPECT_EQ(file.header().channels().findChannel("G")->type, type);
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

TEST(Exr, KeepsEveryBitOfFullFloats) {
    const ScratchFolder folder;
    const Image<RgbF> image = ramp(37, 300);
    write_exr(folder / "a.exr", image, ExrDepth::full).commit();
    EXPECT_EQ(read_image(folder / "a.exr", Imf::FLOAT), image);
    const auto in_pieces = [&](const RowSink& sink) {
        for (std::size_t begin = 0; begin < 300; begin += 70) {
            const std::size_t count = std::min<std::size_t>(70, 300 - begin);
            Image<RgbF> rows(37, count);
            for (std::size_t y = 0; y < count; ++y)
                std::ranges::copy(image.row(begin + y), rows.row(y).begin());
            sink(rows);
        }
    };
    write_exr_rows(folder / "b.exr", 37, 300, in_pieces, ExrDepth::full).commit();
    EXPECT_EQ(read_image(folder / "b.exr", Imf::FLOAT), image);
    EXPECT_NE(in_halves(image), image);
}

TEST(Exr, ComesBackInHalvesWithinTheirPrecision) {
    const ScratchFolder folder;
    const Image<RgbF> image = ramp(37, 21);
    write_exr(folder / "a.exr", image).commit();
    EXPECT_EQ(folder.entries(), 1u);
    const Image<RgbF> back = read_image(folder / "a.exr");
    EXPECT_EQ(back, in_halves(image));
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

TEST(Exr, LevelsComeBackInHalves) {
    const ScratchFolder folder;
    const std::vector<Image<RgbF>> levels{ramp(100, 70), ramp(50, 35), ramp(25, 17), ramp(12, 8),
                                          ramp(6, 4),    ramp(3, 2),   ramp(1, 1)};
    std::vector<const Image<RgbF>*> addresses;
    for (const Image<RgbF>& level : levels) addresses.push_back(&level);
    write_exr_levels(folder / "a.exr", addresses).commit();
    Imf::TiledInputFile file((folder / "a.exr").c_str());
    ASSERT_EQ(file.numLevels(), 7);
    EXPECT_EQ(file.levelMode(), Imf::MIPMAP_LEVELS);
    for (int l = 0; l < 7; ++l) {
        const std::size_t width = levels[std::size_t(l)].width();
        Image<RgbF> image(width, levels[std::size_t(l)].height());
        ASSERT_EQ(file.levelWidth(l), int(width));
        char* base = reinterpret_cast<char*>(&image(0, 0));
        Imf::FrameBuffer frame;
        const char* names[] = {"R", "G", "B"};
        for (std::size_t c = 0; c < 3; ++c)
            frame.insert(names[c],
                         Imf::Slice(Imf::FLOAT, base + 4 * c, sizeof(RgbF), sizeof(RgbF) * width));
        file.setFrameBuffer(frame);
        file.readTiles(0, file.numXTiles(l) - 1, 0, file.numYTiles(l) - 1, l);
        EXPECT_EQ(image, in_halves(levels[std::size_t(l)])) << l;
    }
}

TEST(Exr, LevelsWhoseRowsComeInAnyNumbersAreTheSameFile) {
    const ScratchFolder folder;
    for (const std::size_t height : {150u, 128u}) {
        std::vector<Image<RgbF>> levels{ramp(100, height)};
        while (levels.back().width() > 1 || levels.back().height() > 1)
            levels.push_back(ramp(std::max<std::size_t>(1, levels.back().width() / 2),
                                  std::max<std::size_t>(1, levels.back().height() / 2)));
        std::vector<const Image<RgbF>*> addresses;
        for (const Image<RgbF>& level : levels) addresses.push_back(&level);
        write_exr_levels(folder / "whole.exr", addresses).commit();
        const auto in_bands = [&](const RowSink& sink) {
            for (std::size_t y = 0, rows = 1; y < height; y += rows, ++rows) {
                rows = std::min(rows, height - y);
                Image<RgbF> band(100, rows);
                for (std::size_t j = 0; j < rows; ++j)
                    std::ranges::copy(levels[0].row(y + j), band.row(j).begin());
                sink(band);
            }
            return std::vector<Image<RgbF>>(levels.begin() + 1, levels.end());
        };
        write_exr_levels(folder / "bands.exr", 100, height, in_bands).commit();
        EXPECT_EQ(read_file_bytes(folder / "bands.exr"), read_file_bytes(folder / "whole.exr"));
    }
}

}  // namespace
}  // namespace burl
