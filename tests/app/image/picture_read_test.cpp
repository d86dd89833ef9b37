// Pictures as they are read: against libjpeg's and libwebp's own decoders by what was written, and
// what is damaged.
#include "app/image/picture_read.h"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/image/picture_coding.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

using testing::HasSubstr;

using Bytes = std::vector<std::uint8_t>;

/// Two ramps and a grey, or with alpha a third ramp.
template <class Pixel>
Image<Pixel> ramps(std::size_t width, std::size_t height) {
    Image<Pixel> image(width, height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            image(x, y).r = std::uint8_t(4 * x), image(x, y).g = std::uint8_t(5 * y);
            image(x, y).b = 128;
            if constexpr (sizeof(Pixel) == 4) image(x, y).a = std::uint8_t(255 - 3 * x);
        }
    return image;
}

template <class Pixel>
Bytes encoded(const Image<Pixel>& image, const std::string& coding) {
    Bytes bytes;
    encode_picture(
        image,
        [&](std::span<const std::uint8_t> some) {
            bytes.insert(bytes.end(), some.begin(), some.end());
        },
        coding_named(coding));
    return bytes;
}

TEST(PictureRead, JpegIsCloseAtFullQuality) {
    const Image<Rgb8> image = ramps<Rgb8>(51, 37);
    const PictureColors read = decode_picture(encoded(image, "jpeg:100"), "a.jpg");
    const auto& found = std::get<Image<Rgb8>>(read);
    ASSERT_EQ(found.width(), 51u);
    ASSERT_EQ(found.height(), 37u);
    int worst = 0;
    for (std::size_t y = 0; y < 37; ++y)
        for (std::size_t x = 0; x < 51; ++x) {
            const Rgb8 &a = found(x, y), &b = image(x, y);
            worst =
                std::max({worst, std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
        }
    EXPECT_LE(worst, 3);
}

TEST(PictureRead, GreyJpegHasThreeEqualChannels) {
    Image<Grey8> grey(16, 16, 77);
    const PictureColors read = decode_picture(encoded(grey, "jpeg:100"), "a.jpg");
    EXPECT_EQ(std::get<Image<Rgb8>>(read)(5, 5), (Rgb8{77, 77, 77}));
}

TEST(PictureRead, WebpKeepsEveryCode) {
    const Image<Rgb8> opaque = ramps<Rgb8>(51, 37);
    EXPECT_TRUE(std::get<Image<Rgb8>>(decode_picture(encoded(opaque, "webp"), "a")) == opaque);
    const Image<Rgba8> clear = ramps<Rgba8>(51, 37);
    EXPECT_TRUE(std::get<Image<Rgba8>>(decode_picture(encoded(clear, "webp"), "a")) == clear);
}

/// No pixel is made up.
TEST(PictureRead, EveryTruncationIsRefused) {
    for (const char* coding : {"jpeg", "webp", "png"}) {
        const Bytes whole = encoded(ramps<Rgb8>(40, 40), coding);
        for (std::size_t size = 0; size + 2 < whole.size(); ++size)
            EXPECT_THROW(decode_picture(std::span(whole).first(size), "a"), Error)
                << coding << ' ' << size;
    }
}

TEST(PictureRead, OtherFormatsAreNamed) {
    const auto sentence = [](const Bytes& bytes) -> std::string {
        try {
            decode_picture(bytes, "a.dds");
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::unsupported);
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(sentence({'D', 'D', 'S', ' '}),
              "a.dds is of unknown type; convert it to PNG, JPEG or WebP");
    EXPECT_THAT(sentence(encoded(ramps<Rgb8>(4, 4), "ktx2")), HasSubstr("is KTX2"));
}

/// A head of 65,535 x 65,535 pixels in front of few bytes takes no memory.
TEST(PictureRead, AJpegThatIsTooShortForItsSizeIsRefused) {
    Bytes bytes = encoded(ramps<Rgb8>(8, 8), "jpeg");
    const Bytes head{0xff, 0xc0, 0, 17, 8};
    const auto frame = std::ranges::search(bytes, head);
    ASSERT_FALSE(frame.empty());
    const auto at = std::size_t(frame.begin() - bytes.begin()) + head.size();
    for (const std::uint8_t side : {std::uint8_t(0x3f), std::uint8_t(0xff)}) {
        bytes[at] = bytes[at + 2] = side;
        try {
            decode_picture(bytes, "a.jpg");
            FAIL();
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr(side == 0xff ? "2^28" : "too short"));
        }
    }
}

}  // namespace
}  // namespace burl
