// Pictures and environments.
#include "app/image/picture_read.h"
#include "app/light/environment.h"
#include "atlas/base/error.h"
#include "tests/fuzz/target.h"

namespace burl::fuzz {
namespace {

std::span<const std::uint8_t> span_of(const std::string& bytes) {
    return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

void read_picture_bytes_of(const std::string& bytes) {
    const auto [colors, alpha] = colors_and_alpha(decode_picture(span_of(bytes), "a.png"));
    require(alpha.width() == 0 || alpha.width() == colors.width(), "alpha has the picture's size");
}

/// The size that a file's head declares, then its pixels.
void read_picture_file(const std::string& bytes) {
    picture_size(scratch_file("a.png", bytes));
    read_picture_bytes_of(bytes);
}

void read_exr_file(const std::string& bytes) {
    load_environment(scratch_file("a.exr", bytes));
}

void read_hdr_file(const std::string& bytes) {
    load_environment(scratch_file("a.hdr", bytes));
}

}  // namespace

std::vector<Target> picture_targets() {
    return {{"png", read_picture_file, Form::png, {"tests/cases/p64.png"}, {}},
            {"picture", read_picture_file, Form::binary, {}, {}},
            {"exr",
             read_exr_file,
             Form::binary,
             {},
             {"channels", "compression", "dataWindow", "lineOrder", "tiles", "box2i", "chlist",
              "half", "R", "G", "B", "Y", "type", "chunkCount", "deepscanline"}},
            {"hdr",
             read_hdr_file,
             Form::binary,
             {},
             {"#?RADIANCE\n", "FORMAT=32-bit_rle_rgbe\n", "FORMAT=32-bit_rle_xyze\n",
              "EXPOSURE=", "-Y 2 +X 4\n", "-Y 1 +X 2\n", "GAMMA=", "COLORCORR="}}};
}

}  // namespace burl::fuzz
