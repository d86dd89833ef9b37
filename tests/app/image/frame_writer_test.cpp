// Files of frames, decoded by other libraries, or by a reader of chunks of its own.
#include "app/image/frame_writer.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "atlas/base/error.h"
#include "tests/app/support/decoded_frames.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

constexpr std::size_t frame_width = 40, frame_height = 28;

/// A ball of many colours that moves over a flat ground.
Image<Rgb8> moving_ball(int i) {
    Image<Rgb8> image(frame_width, frame_height, Rgb8{176, 176, 176});
    for (std::size_t y = 0; y < frame_height; ++y)
        for (std::size_t x = 0; x < frame_width; ++x)
            if (std::hypot(double(x) - 12 - 3 * i, double(y) - 13) < 9)
                image(x, y) = {std::uint8_t(7 * x), std::uint8_t(9 * y),
                               std::uint8_t(31 * (x + 3 * y))};
    return image;
}

/// A frame without a ground, half transparent on its left side.
Image<Rgba8> ball_alone(int i) {
    return converted<Rgba8>(moving_ball(i), [](const Rgb8& c) -> Rgba8 {
        if (c == Rgb8{176, 176, 176}) return {0, 0, 0, 0};
        return {c.r, c.g, c.b, std::uint8_t(c.r < 100 ? 127 : 255)};
    });
}

template <class MakeFrame>
DecodedFrames written(const std::string& path, int frames, double rate, const MakeFrame& frame,
                      int quality = lossless_quality) {
    const auto writer = frame_writer({path}, {frames, rate, quality});
    for (int i = 0; i < frames; ++i) writer->add(frame(i));
    writer->commit();
    return decoded_frames(path);
}

double rms(const Image<Rgba8>& a, const Image<Rgb8>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < b.pixels().size(); ++i) {
        const Rgba8& p = a.pixels()[i];
        const Rgb8& q = b.pixels()[i];
        for (const int d : {p.r - q.r, p.g - q.g, p.b - q.b}) sum += d * d;
    }
    return std::sqrt(sum / (3.0 * double(b.pixels().size())));
}

TEST(FrameWriter, LosslessFormatsKeepEveryPixelOfEveryFrame) {
    const ScratchFolder scratch;
    for (const std::string name : {"a.webp", "a.apng"}) {
        const DecodedFrames decoded = written(scratch / name, 5, 24.0, moving_ball);
        ASSERT_EQ(decoded.frames.size(), 5u) << name;
        EXPECT_EQ(decoded.plays, 0);
        EXPECT_THAT(decoded.milliseconds, testing::ElementsAre(42, 41, 42, 42, 41)) << name;
        for (int i = 0; i < 5; ++i)
            EXPECT_EQ(decoded.frames[std::size_t(i)], opaque(moving_ball(i))) << name << i;
    }
}

TEST(FrameWriter, LosslessFormatsKeepAlpha) {
    const ScratchFolder scratch;
    for (const std::string name : {"a.webp", "a.apng"}) {
        const DecodedFrames decoded = written(scratch / name, 3, 10.0, ball_alone);
        ASSERT_EQ(decoded.frames.size(), 3u) << name;
        for (int i = 0; i < 3; ++i) {
            const Image<Rgba8> wanted = ball_alone(i);
            for (std::size_t k = 0; k < wanted.pixels().size(); ++k) {
                const Rgba8 &w = wanted.pixels()[k],
                            &d = decoded.frames[std::size_t(i)].pixels()[k];
                ASSERT_EQ(d.a, w.a) << name << i;
                if (w.a > 0) {
                    ASSERT_EQ(d, w) << name << i;
                }
            }
        }
    }
}

TEST(FrameWriter, LossyWebpIsSmallAndNear) {
    const ScratchFolder scratch;
    std::uintmax_t before = 0;
    for (const int quality : {20, 90}) {
        const std::string path = scratch / "a.webp";
        const DecodedFrames decoded = written(path, 4, 25.0, moving_ball, quality);
        ASSERT_EQ(decoded.frames.size(), 4u);
        EXPECT_EQ(decoded.duration(), 160);
        for (int i = 0; i < 4; ++i)
            EXPECT_LT(rms(decoded.frames[std::size_t(i)], moving_ball(i)),
                      quality == 20 ? 40.0 : 20.0);
        const std::uintmax_t size = std::filesystem::file_size(path);
        EXPECT_GT(size, before) << quality;
        before = size;
    }
}

TEST(FrameWriter, StillWebpIsNoAnimation) {
    const ScratchFolder scratch;
    const Image<Rgb8> image = moving_ball(2);
    written(scratch / "a.webp", 1, 24.0, [&](int) { return image; });
    const std::vector<std::uint8_t> bytes = bytes_of(scratch / "a.webp");
    ::WebPBitstreamFeatures features{};
    ASSERT_EQ(::WebPGetFeatures(bytes.data(), bytes.size(), &features), VP8_STATUS_OK);
    EXPECT_FALSE(features.has_animation);
    int width = 0, height = 0;
    std::uint8_t* rgba = ::WebPDecodeRGBA(bytes.data(), bytes.size(), &width, &height);
    ASSERT_NE(rgba, nullptr);
    EXPECT_EQ(canvas_of(rgba, std::size_t(width), std::size_t(height)), opaque(image));
    ::WebPFree(rgba);
}

TEST(FrameWriter, GifKeepsFewColorsExactlyAndManyNearly) {
    const ScratchFolder scratch;
    const auto few = [](int i) {
        return converted<Rgb8>(moving_ball(i), [](const Rgb8& c) {
            return Rgb8{std::uint8_t(c.r & 0xc0), std::uint8_t(c.g & 0xc0), 9};
        });
    };
    const DecodedFrames exact = written(scratch / "few.gif", 5, 24.0, few);
    const DecodedFrames near = written(scratch / "many.gif", 5, 24.0, moving_ball);
    ASSERT_EQ(exact.frames.size(), 5u);
    ASSERT_EQ(near.frames.size(), 5u);
    EXPECT_EQ(near.plays, 0);
    EXPECT_THAT(near.milliseconds, testing::ElementsAre(40, 40, 50, 40, 40));
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(exact.frames[std::size_t(i)], opaque(few(i))) << i;
        EXPECT_LT(rms(near.frames[std::size_t(i)], moving_ball(i)), 6.0) << i;
        EXPECT_EQ(near.frames[std::size_t(i)](0, 0), (Rgba8{176, 176, 176, 255}));
    }
}

TEST(FrameWriter, GifIsTransparentWhereLessThanHalfIsThere) {
    const ScratchFolder scratch;
    const DecodedFrames decoded = written(scratch / "a.gif", 4, 10.0, ball_alone);
    ASSERT_EQ(decoded.frames.size(), 4u);
    for (int i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < frame_width * frame_height; ++k)
            ASSERT_EQ(decoded.frames[std::size_t(i)].pixels()[k].a > 0,
                      ball_alone(i).pixels()[k].a >= 128)
                << i;
}

TEST(FrameWriter, GifOfOneFrameIsAStill) {
    const ScratchFolder scratch;
    const DecodedFrames decoded = written(scratch / "a.gif", 1, 24.0, moving_ball);
    EXPECT_EQ(decoded.frames.size(), 1u);
    EXPECT_EQ(decoded.plays, -1);
    EXPECT_EQ(decoded.duration(), 0);
}

TEST(FrameWriter, StoresOnlyTheRectangleThatChanges) {
    const ScratchFolder scratch;
    for (const std::string name : {"a.gif", "a.apng"}) {
        const DecodedFrames decoded =
            written(scratch / name, 3, 10.0, [](int i) { return moving_ball(i == 2 ? 1 : i); });
        ASSERT_EQ(decoded.stored_pixels.size(), 3u);
        EXPECT_EQ(decoded.stored_pixels[0], frame_width * frame_height);
        EXPECT_LT(decoded.stored_pixels[1], frame_width * frame_height);
        EXPECT_EQ(decoded.stored_pixels[2], 1u);
        EXPECT_EQ(decoded.duration(), 300);
    }
}

TEST(FrameWriter, ChangedBoxIsTheSmallest) {
    Image<Rgb8> before(9, 7), now(9, 7);
    const auto expect_box = [&](std::size_t x, std::size_t y, std::size_t w, std::size_t h) {
        const PixelBox box = changed_box(before, now);
        EXPECT_EQ(box.x, x);
        EXPECT_EQ(box.y, y);
        EXPECT_EQ(box.width, w);
        EXPECT_EQ(box.height, h);
    };
    expect_box(0, 0, 1, 1);
    now(8, 6).b = 1;
    expect_box(8, 6, 1, 1);
    now(3, 2).r = 1;
    expect_box(3, 2, 6, 5);
}

TEST(FrameWriter, TimesAddUpWithoutDrift) {
    for (const double rate : {0.3, 7.0, 23.976, 24.0, 50.0, 60.0})
        for (const int ticks : {100, 1000}) {
            int sum = 0;
            for (int i = 0; i < 240; ++i) {
                sum += frame_ticks(i, rate, ticks);
                ASSERT_NEAR(sum, (i + 1) * ticks / rate, 0.5 + 1e-9) << rate;
            }
        }
}

TEST(FrameWriter, WithoutCommitLeavesWhatWasThere) {
    const ScratchFolder scratch;
    for (const std::string name : {"a.webp", "a.gif", "a.apng"}) {
        const std::string path = scratch / name;
        frame_writer({path}, {3, 24.0})->add(moving_ball(0));
        EXPECT_EQ(scratch.entries(), 0u) << name;
        std::ofstream(path) << "old";
        frame_writer({path}, {3, 24.0})->add(moving_ball(0));
        EXPECT_EQ(bytes_of(path).size(), 3u) << name;
        EXPECT_EQ(scratch.entries(), 1u) << name;
        std::filesystem::remove(path);
    }
}

ExitCode refusal(const std::string& path, const FrameFile& file, const Picture& picture) {
    try {
        frame_writer({path}, file)->add(picture);
    } catch (const Error& error) {
        return error.code();
    }
    return ExitCode::ok;
}

TEST(FrameWriter, RefusesWhatAFormatCannotHold) {
    const ScratchFolder scratch;
    const Picture small = Image<Rgb8>(2, 2), wide = Image<Rgb8>(16384, 1);
    EXPECT_EQ(refusal(scratch / "a.gif", {2, 50.5}, small), ExitCode::usage);
    EXPECT_EQ(refusal(scratch / "a.gif", {2, 50.0}, small), ExitCode::ok);
    EXPECT_EQ(refusal(scratch / "a.webp", {1, 24.0}, wide), ExitCode::unsupported);
    EXPECT_EQ(refusal(scratch / "a.gif", {1, 24.0}, Image<Rgb8>(65536, 1)), ExitCode::unsupported);
    EXPECT_EQ(refusal(scratch / "a.jpg", {1, 24.0}, small), ExitCode::usage);
    EXPECT_EQ(picture_format("A.WebP"), PictureFormat::webp);
    EXPECT_EQ(scratch.entries(), 0u);
}

}  // namespace
}  // namespace burl
