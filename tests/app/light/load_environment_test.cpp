// Maps of all directions from files: .exr written by OpenEXR, .hdr written here byte by byte.
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/image/exr_io.h"
#include "app/light/environment.h"
#include "atlas/base/error.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

using testing::HasSubstr;

void write_bytes(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

std::string hdr_header(std::size_t width, std::size_t height, const std::string& more = "") {
    return "#?RADIANCE\n# a comment\n" + more + "FORMAT=32-bit_rle_rgbe\n\n-Y " +
           std::to_string(height) + " +X " + std::to_string(width) + "\n";
}

/// A row of `width` pixels whose components are 10 + x, 20, 30 and the exponent 128 + e: runs but
/// for the first component.
std::string packed_row(std::size_t width, int e) {
    std::string row{2, 2, char(width >> 8), char(width & 255)};
    row += char(width);
    for (std::size_t x = 0; x < width; ++x) row += char(10 + x);
    for (const int value : {20, 30, 128 + e}) row += {char(128 + width), char(value)};
    return row;
}

std::string packed_file(std::size_t width) {
    std::string file = hdr_header(width, width / 2);
    for (std::size_t y = 0; y < width / 2; ++y) file += packed_row(width, int(y) - 2);
    return file;
}

void expect_refused(const std::string& path, ExitCode code, const std::string& part) {
    try {
        load_environment(path);
        FAIL() << part;
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), code) << e.what();
        EXPECT_THAT(e.what(), HasSubstr(part));
        EXPECT_THAT(e.what(), HasSubstr(path));
        EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    }
}

TEST(LoadEnvironment, ReadsCompressedRadiancePictures) {
    const ScratchFolder folder;
    write_bytes(folder / "a.HDR", packed_file(16));
    const Image<RgbF> map = load_environment(folder / "a.HDR").radiance;
    ASSERT_EQ(map.width(), 16u);
    ASSERT_EQ(map.height(), 8u);
    for (std::size_t y = 0; y < 8; ++y)
        for (std::size_t x = 0; x < 16; ++x) {
            const double unit = std::pow(2.0, double(y) - 2.0 - 8.0);
            EXPECT_EQ(map(x, y), (RgbF{float(unit * (10.0 + double(x))), float(unit * 20.0),
                                       float(unit * 30.0)}));
        }
}

TEST(LoadEnvironment, ReadsPlainAndOldRadiancePictures) {
    const ScratchFolder folder;
    std::string file = hdr_header(4, 2, "EXPOSURE=2\nEXPOSURE=0.25\n");
    const std::string first{64, 32, 16, char(129)}, black{0, 0, 0, 0};
    file += first + std::string{1, 1, 1, 3};  // repeated three times
    file += black + first + black + first;
    write_bytes(folder / "a.hdr", file);
    const Image<RgbF> map = load_environment(folder / "a.hdr").radiance;
    // 64/256 * 2 by the file, over the exposures' product 0.5.
    const RgbF bright{1.0f, 0.5f, 0.25f};
    for (std::size_t x = 0; x < 4; ++x) EXPECT_EQ(map(x, 0), bright);
    EXPECT_EQ(map(0, 1), RgbF{});
    EXPECT_EQ(map(1, 1), bright);
    EXPECT_EQ(map(3, 1), bright);
}

TEST(LoadEnvironment, ReadsExrWithinHalves) {
    const ScratchFolder folder;
    Image<RgbF> map(32, 16);
    for (std::size_t y = 0; y < 16; ++y)
        for (std::size_t x = 0; x < 32; ++x)
            map(x, y) = {float(x) * 100.0f, 1.0f / float(y + 1), 0.125f};
    write_exr(folder / "a.exr", map).commit();
    const Image<RgbF> back = load_environment(folder / "a.exr").radiance;
    ASSERT_EQ(back.width(), 32u);
    for (std::size_t y = 0; y < 16; ++y)
        for (std::size_t x = 0; x < 32; ++x) {
            EXPECT_EQ(back(x, y).r, map(x, y).r);
            EXPECT_NEAR(back(x, y).g, map(x, y).g, map(x, y).g * 0x1p-11f);
        }
}

TEST(LoadEnvironment, RefusesFilesThatEndTooEarly) {
    const ScratchFolder folder;
    const std::string whole = packed_file(16);
    for (const std::size_t length :
         {std::size_t(0), std::size_t(5), std::size_t(40), whole.size() / 2, whole.size() - 1}) {
        write_bytes(folder / "a.hdr", whole.substr(0, length));
        expect_refused(folder / "a.hdr", ExitCode::invalid_file, "");
    }
    write_exr(folder / "whole.exr", Image<RgbF>(64, 32, {1.0f, 2.0f, 3.0f})).commit();
    std::ifstream stream(folder / "whole.exr", std::ios::binary);
    const std::string exr{std::istreambuf_iterator<char>(stream), {}};
    for (const std::size_t length :
         {std::size_t(0), std::size_t(3), exr.size() / 4, exr.size() - 9}) {
        write_bytes(folder / "b.exr", exr.substr(0, length));
        expect_refused(folder / "b.exr", ExitCode::invalid_file, "");
    }
}

TEST(LoadEnvironment, RefusesDamagedFilesWhereverOneByteIsWrong) {
    const ScratchFolder folder;
    const std::string whole = packed_file(16);
    for (std::size_t at = 0; at < whole.size(); at += 3) {
        std::string damaged = whole;
        damaged[at] = char(damaged[at] ^ 0x5f);
        write_bytes(folder / "a.hdr", damaged);
        try {
            load_environment(folder / "a.hdr");
        } catch (const Error&) {  // a sentence, or another picture: never a crash
        }
    }
}

TEST(LoadEnvironment, RefusesHugeClaimsWithoutMakingRoom) {
    const ScratchFolder folder;
    write_bytes(folder / "a.hdr", hdr_header(400'000'000, 200'000'000) + packed_row(16, 0));
    expect_refused(folder / "a.hdr", ExitCode::invalid_file, "2^27 pixels");
    write_bytes(folder / "b.hdr", hdr_header(16000, 8000) + packed_row(16, 0));
    expect_refused(folder / "b.hdr", ExitCode::invalid_file, "truncated");
    write_bytes(folder / "c.hdr", "#?RADIANCE\n" + std::string(10'000, 'x'));
    expect_refused(folder / "c.hdr", ExitCode::invalid_file, "no header");
}

TEST(LoadEnvironment, RefusesExrThatClaimsMoreThanItsBytesCanHold) {
    const ScratchFolder folder;
    write_exr(folder / "whole.exr", Image<RgbF>(64, 32)).commit();
    std::ifstream stream(folder / "whole.exr", std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    // Black packs best of all, and is read.
    EXPECT_EQ(load_environment(folder / "whole.exr").radiance.width(), 64u);
    // The window's last column and row stand behind the names, a length and the first ones.
    const std::string_view names("dataWindow\0box2i\0", 17);
    const std::size_t at = bytes.find(names) + names.size() + 4 + 8;
    const std::int32_t last[] = {15999999, 7};  // as many rows as one table of offsets has
    std::memcpy(bytes.data() + at, last, sizeof last);
    write_bytes(folder / "a.exr", bytes);
    expect_refused(folder / "a.exr", ExitCode::invalid_file, "claims 128000000 pixels");
}

TEST(LoadEnvironment, RefusesLightThatIsNone) {
    const ScratchFolder folder;
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), -0.5f, std::numeric_limits<float>::infinity()}) {
        Image<RgbF> map(8, 4, {1.0f, 1.0f, 1.0f});
        map(5, 2).g = bad;
        write_exr(folder / "a.exr", map).commit();
        expect_refused(folder / "a.exr", ExitCode::invalid_file, "at pixel 5, 2");
    }
}

TEST(LoadEnvironment, RefusesOtherSidesAndOtherFiles) {
    const ScratchFolder folder;
    write_exr(folder / "a.exr", Image<RgbF>(8, 8, {1.0f, 1.0f, 1.0f})).commit();
    expect_refused(folder / "a.exr", ExitCode::invalid_file, "twice as wide as high");
    write_bytes(folder / "b.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 4 +X 8\n");
    expect_refused(folder / "b.hdr", ExitCode::unsupported, "RGBE");
    write_bytes(folder / "c.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n+Y 4 +X 8\n");
    expect_refused(folder / "c.hdr", ExitCode::unsupported, "top left");
    write_bytes(folder / "d.hdr", "no picture");
    expect_refused(folder / "d.hdr", ExitCode::invalid_file, "no header");
    expect_refused(folder / "none.hdr", ExitCode::io, "");
    expect_refused(folder / "sky.png", ExitCode::usage, ".exr or .hdr");
}

}  // namespace
}  // namespace burl
