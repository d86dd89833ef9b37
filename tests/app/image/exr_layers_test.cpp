// EXR files of several images, read back by the OpenEXR library itself.
#include "app/image/exr_layers.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfTiledInputFile.h>

#include "app/base/file_bytes.h"
#include "atlas/base/error.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

/// Numbers that halves hold.
float number(std::size_t x, std::size_t y, std::size_t c) {
    return float(x) / 64.0f + float(y * (c + 1)) / 128.0f;
}

template <class Pixel>
Image<Pixel> image_of(std::size_t width, std::size_t height) {
    Image<Pixel> image(width, height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            auto* at = reinterpret_cast<float*>(&image(x, y));
            for (std::size_t c = 0; c < sizeof(Pixel) / 4; ++c) at[c] = number(x, y, c);
        }
    return image;
}

std::set<std::string> channels_of(const Imf::Header& header) {
    std::set<std::string> names;
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
        EXPECT_EQ(c.channel().type, Imf::HALF);
        names.insert(c.name());
    }
    return names;
}

/// One channel of a level of a file.
template <class File, class Read>
Image<float> channel(File& file, const std::string& name, std::size_t width, std::size_t height,
                     const Read& read) {
    Image<float> image(width, height);
    Imf::FrameBuffer frame;
    frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&image(0, 0)), 4, 4 * width));
    file.setFrameBuffer(frame);
    read();
    return image;
}

void expect_numbers(const Image<float>& image, std::size_t c, const std::string& name) {
    for (std::size_t y = 0; y < image.height(); ++y)
        for (std::size_t x = 0; x < image.width(); ++x)
            ASSERT_EQ(image(x, y), number(x, y, c)) << name << " " << x << ", " << y;
}

TEST(ExrLayers, EveryChannelComesBackUnderItsName) {
    const ScratchFolder folder;
    constexpr std::size_t width = 37, height = 300;  // more rows than are converted at once
    const auto color = image_of<RgbaF>(width, height);
    const auto normal = image_of<RgbF>(width, height);
    const auto metallic = image_of<float>(width, height);
    const std::vector<ExrLayer> layers{
        {"", "RGBA", {&color}}, {"normal", "XYZ", {&normal}}, {"metallic", "Y", {&metallic}}};
    write_exr_layers(folder / "a.exr", layers).commit();
    EXPECT_EQ(folder.entries(), 1u);
    Imf::InputFile file((folder / "a.exr").c_str());
    EXPECT_EQ(channels_of(file.header()),
              (std::set<std::string>{"R", "G", "B", "A", "normal.X", "normal.Y", "normal.Z",
                                     "metallic.Y"}));
    std::set<std::string> names;
    file.header().channels().layers(names);
    EXPECT_EQ(names, (std::set<std::string>{"metallic", "normal"}));
    const std::pair<const char*, std::size_t> all[] = {
        {"R", 0},        {"G", 1},        {"B", 2},        {"A", 3},
        {"normal.X", 0}, {"normal.Y", 1}, {"normal.Z", 2}, {"metallic.Y", 0}};
    for (const auto& [name, c] : all)
        expect_numbers(
            channel(file, name, width, height, [&] { file.readPixels(0, int(height) - 1); }), c,
            name);
}

TEST(ExrLayers, LevelsComeBack) {
    const ScratchFolder folder;
    std::vector<Image<RgbaF>> colors;
    std::vector<Image<float>> numbers;
    for (std::size_t w = 100, h = 70;;
         w = std::max<std::size_t>(w / 2, 1), h = std::max<std::size_t>(h / 2, 1)) {
        colors.push_back(image_of<RgbaF>(w, h));
        numbers.push_back(image_of<float>(w, h));
        if (w == 1 && h == 1) break;
    }
    ExrLayer color{"", "RGBA", {}}, rough{"roughness", "Y", {}};
    for (const auto& level : colors) color.levels.push_back(&level);
    for (const auto& level : numbers) rough.levels.push_back(&level);
    write_exr_layers(folder / "a.exr", std::vector{color, rough}).commit();
    Imf::TiledInputFile file((folder / "a.exr").c_str());
    ASSERT_EQ(file.numLevels(), 7);
    const std::pair<const char*, std::size_t> all[] = {{"A", 3}, {"roughness.Y", 0}};
    for (int l = 0; l < 7; ++l)
        for (const auto& [name, c] : all) {
            const auto w = std::size_t(file.levelWidth(l)), h = std::size_t(file.levelHeight(l));
            const auto read = [&] {
                file.readTiles(0, file.numXTiles(l) - 1, 0, file.numYTiles(l) - 1, l);
            };
            expect_numbers(channel(file, name, w, h, read), c, name);
        }
}

TEST(ExrLayers, RowsMakeTheFileOfWholeImages) {
    const ScratchFolder folder;
    constexpr std::size_t size = 150;
    for (const bool has_levels : {false, true})
        for (const ExrDepth depth : {ExrDepth::half, ExrDepth::full}) {
            std::vector<Image<RgbaF>> colors;
            std::vector<Image<float>> numbers;
            for (std::size_t side = size; side > 0; side = has_levels ? side / 2 : 0) {
                colors.push_back(image_of<RgbaF>(side, side));
                numbers.push_back(image_of<float>(side, side));
            }
            ExrLayer color{"", "RGBA", {}}, rough{"roughness", "Y", {}};
            for (const auto& level : colors) color.levels.push_back(&level);
            for (const auto& level : numbers) rough.levels.push_back(&level);
            const std::vector layers{color, rough};
            write_exr_layers(folder / "whole.exr", layers, depth).commit();
            const LayerRowSource source = [&](const LayerRowSink& sink) {
                for (std::size_t y = 0; y < size; y += 64) {
                    const std::size_t rows = std::min<std::size_t>(64, size - y);
                    auto some = Image<RgbaF>::unset(size, rows);
                    auto few = Image<float>::unset(size, rows);
                    std::copy_n(&colors[0](0, y), size * rows, &some(0, 0));
                    std::copy_n(&numbers[0](0, y), size * rows, &few(0, 0));
                    sink(std::vector<FloatImage>{&some, &few});
                }
                std::vector<std::vector<FloatImage>> levels;
                for (const ExrLayer& layer : layers)
                    levels.emplace_back(layer.levels.begin() + 1, layer.levels.end());
                return levels;
            };
            const std::vector<ExrLayer> bare{{"", "RGBA", {}}, {"roughness", "Y", {}}};
            write_exr_layers(folder / "rows.exr", size, bare, source, has_levels, depth).commit();
            EXPECT_EQ(read_file_bytes(folder / "rows.exr"), read_file_bytes(folder / "whole.exr"))
                << has_levels;
        }
}

TEST(ExrLayers, RowsOfHalfATileAreRefused) {
    const ScratchFolder folder;
    const Image<float> rows(128, 32), rest(128, 96);
    const LayerRowSource source = [&](const LayerRowSink& sink) {
        sink(std::vector<FloatImage>{&rows});
        sink(std::vector<FloatImage>{&rest});
        return std::vector<std::vector<FloatImage>>();
    };
    const std::vector<ExrLayer> layers{{"b", "Y", {}}};
    EXPECT_THROW(write_exr_layers(folder / "a.exr", 128, layers, source, true), Error);
}

TEST(ExrLayers, LayersThatDoNotFitAreRefusedWithTheirName) {
    const ScratchFolder folder;
    const Image<float> a(8, 8), other(8, 4), half(4, 4), wrong(3, 4);
    const Image<RgbF> colors(8, 8);
    const std::vector<ExrLayer> bad[] = {
        {{"a", "Y", {&a}}, {"b", "Y", {&other}}},
        {{"a", "Y", {&a}}, {"b", "Y", {&a, &half}}},
        {{"a", "Y", {&a}}, {"b", "Y", {&colors}}},
        {{"b", "Y", {&a}}, {"b", "Y", {&a}}},
        {{"b", "XX", {}}},
        {{"b", "Y", {&a, &wrong}}},
        {{"b", "Y", {&a, &half}}},
    };
    for (const auto& layers : bad) {
        try {
            write_exr_layers(folder / "a.exr", layers);
            ADD_FAILURE() << "was written";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::runtime);
            EXPECT_NE(std::string(error.what()).find("\"b\""), std::string::npos) << error.what();
        }
    }
    EXPECT_EQ(folder.entries(), 0u);
}

}  // namespace
}  // namespace burl
