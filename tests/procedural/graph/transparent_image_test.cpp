// Images with alpha: what is averaged is the colour times alpha, so that the colour of transparent
// texels, here a bright green, is seen nowhere.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "atlas/base/json.h"
#include "procedural/color/srgb.h"
#include "procedural/graph/planes.h"
#include "procedural/graph/values.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

constexpr Rgba8 seen{200, 0, 40, 255}, hidden{0, 255, 0, 0};

/// Texels that are seen and such that are hidden, at random.
Image<Rgba8> torn(std::size_t width, std::size_t height) {
    std::mt19937 random(11);
    Image<Rgba8> image(width, height);
    for (std::size_t y = 0; y < height; ++y)
        for (Rgba8& texel : image.row(y)) texel = random() % 3 == 0 ? hidden : seen;
    return image;
}

TextureGraph graph_with(const Image<Rgba8>& image, const std::string& json) {
    return graph_from_json(nlohmann::ordered_json::parse(json),
                           [&](const std::string&, ImageWrap wrap) {
                               return std::make_shared<const MipImage>(image, wrap);
                           });
}

/// Red over alpha is that of the seen texels, green is nowhere, and no colour exceeds its alpha.
void expect_no_fringe(const Vec3d& color, double alpha) {
    EXPECT_GE(alpha, 0.0);
    EXPECT_LE(alpha, 1.0 + 1e-9);
    EXPECT_EQ(color.y, 0.0);
    EXPECT_LE(std::max(color.x, color.z), alpha + 1e-9);
    EXPECT_NEAR(color.x, alpha * srgb_decode(200 / 255.0), 1e-6);
}

TEST(TransparentImage, LevelsAreMeansOfColoursTimesAlpha) {
    Image<Rgba8> source(4, 2);
    std::mt19937 random(2);
    Vec4d mean(0.0);
    for (std::size_t y = 0; y < 2; ++y)
        for (Rgba8& c : source.row(y)) {
            c = {std::uint8_t(random()), std::uint8_t(random()), std::uint8_t(random()),
                 std::uint8_t(random())};
            const double alpha = c.a / 255.0;
            mean += Vec4d(alpha * srgb_decode(c.r / 255.0), alpha * srgb_decode(c.g / 255.0),
                          alpha * srgb_decode(c.b / 255.0), alpha) /
                    8.0;
        }
    const MipImage image(source, ImageWrap::repeat);
    ASSERT_NE(image.alpha(), nullptr);
    const RgbF top = image.texel(image.level_count() - 1, 0, 0),
               alpha = image.alpha()->texel(image.alpha()->level_count() - 1, 0, 0);
    EXPECT_NEAR(double(top.r), mean.x, 1e-6);
    EXPECT_NEAR(double(top.g), mean.y, 1e-6);
    EXPECT_NEAR(double(top.b), mean.z, 1e-6);
    EXPECT_NEAR(double(alpha.r), mean.w, 1e-6);
    EXPECT_EQ(image.alpha()->alpha(), nullptr);
}

TEST(TransparentImage, HiddenColoursAreSeenInNoLookup) {
    // Sides that are powers of two, and sides that Lanczos's filter makes so.
    for (const auto& [width, height] :
         {std::pair<std::size_t, std::size_t>{16, 8}, {12, 8}, {13, 7}})
        for (const ImageWrap wrap : {ImageWrap::repeat, ImageWrap::black, ImageWrap::clamp}) {
            const MipImage image(torn(width, height), wrap);
            const MipImage& alpha = *image.alpha();
            // Resampling cuts what overshoots, colour and alpha each by itself.
            const bool exact = width == 16;
            for (const Vec3d& p : random_points(40, 1.5, 4)) {
                const auto check = [&](const auto& lookup) {
                    const Vec3d color = lookup(image).color, a = lookup(alpha).color;
                    if (exact) return expect_no_fringe(color, a.x);
                    EXPECT_EQ(color.y, 0.0);
                    EXPECT_LE(color.x, a.x + 1e-6);
                    EXPECT_LE(a.x, 1.0 + 1e-6);
                };
                check([&](const MipImage& one) { return one.bilinear(0, p.x, p.y); });
                check([&](const MipImage& one) { return one.trilinear(p.x, p.y, 0.2); });
                check([&](const MipImage& one) {
                    return one.ewa(p.x, p.y, {0.2, 0.05}, {-0.02, 0.1}, 8);
                });
            }
        }
}

TEST(TransparentImage, ResamplingKeepsAConstantsAlpha) {
    const MipImage image(Image<Rgba8>(5, 3, {200, 100, 50, 102}), ImageWrap::clamp);
    for (std::size_t y = 0; y < image.height(0); ++y)
        for (std::size_t x = 0; x < image.width(0); ++x) {
            EXPECT_NEAR(double(image.texel(0, x, y).r), 0.4 * srgb_decode(200 / 255.0), 1e-6);
            EXPECT_NEAR(double(image.alpha()->texel(0, x, y).g), 0.4, 1e-6);
        }
}

TEST(TransparentImage, AnOpaqueChannelOfAlphaChangesNothing) {
    const Image<Rgb8> plain = case_image("");
    Image<Rgba8> with_alpha(12, 16);
    for (std::size_t y = 0; y < 16; ++y)
        for (std::size_t x = 0; x < 12; ++x)
            with_alpha(x, y) = {plain(x, y).r, plain(x, y).g, plain(x, y).b, 255};
    const MipImage image(with_alpha, ImageWrap::repeat);
    EXPECT_EQ(image.alpha(), nullptr);
    EXPECT_EQ(image, MipImage(plain, ImageWrap::repeat));
    with_alpha(3, 3).a = 254;
    EXPECT_FALSE(image == MipImage(with_alpha, ImageWrap::repeat));
    with_alpha(3, 3).a = 0;
    const MipImage other(with_alpha, ImageWrap::repeat);
    EXPECT_EQ(other, MipImage(with_alpha, ImageWrap::repeat));
}

TEST(TransparentImage, NodesGiveItsAlpha) {
    const Image<Rgba8> source = torn(16, 8);
    for (const char* lookup : {"trilinear", "ewa"}) {
        const TextureGraph graph =
            graph_with(source, std::string(R"({"node": "image", "file": "i.png", "lookup": ")") +
                                   lookup + "\"}");
        EXPECT_FALSE(is_opaque(graph, graph.result));
        for (const Vec3d& p : random_points(50, 1.2, 21)) {
            const GraphSample point = GraphEvaluator(graph)(p);
            expect_no_fringe(point.color(), point.channels[3].value);
            const GraphSample mean = GraphEvaluator(graph)(p, {{0.1, 0.02, 5}, {-0.03, 0.2, 7}});
            expect_no_fringe(mean.color(), mean.channels[3].value);
        }
    }
}

TEST(TransparentImage, ALookupIsTheMeanOfItsTexels) {
    // Four texels meet at the origin of an image of 2 x 2 texels that repeats.
    Image<Rgba8> four(2, 2, hidden);
    four(0, 0) = seen;
    four(1, 1) = {200, 0, 40, 51};
    const TextureGraph graph = graph_with(four, R"({"node": "image", "file": "i.png"})");
    const GraphSample sample = GraphEvaluator(graph)({0, 0, 0});
    EXPECT_NEAR(sample.channels[3].value, (1.0 + 0.2) / 4.0, 1e-7);
    EXPECT_NEAR(sample.channels[0].value, 0.3 * srgb_decode(200 / 255.0), 1e-7);
    EXPECT_EQ(sample.channels[1].value, 0.0);
}

TEST(TransparentImage, BeyondItLiesNothing) {
    const TextureGraph graph =
        graph_with(torn(16, 8), R"({"node": "image", "file": "i.png", "wrap": "black"})");
    EXPECT_EQ(GraphEvaluator(graph)({1.5, 0.5, 0}).channels[3].value, 0.0);
    const TextureGraph opaque = graph_with(
        Image<Rgba8>(4, 4, seen), R"({"node": "image", "file": "i.png", "wrap": "black"})");
    EXPECT_EQ(GraphEvaluator(opaque)({1.5, 0.5, 0}).channels[3].value, 1.0);
    EXPECT_TRUE(is_opaque(opaque, opaque.result));
}

TEST(TransparentImage, ValuesAloneAreTheReferences) {
    const TextureGraph graph =
        graph_with(torn(12, 8), R"({"node": "image", "file": "i.png", "wrap": "clamp"})");
    const GraphValues values(graph, nullptr, GraphOutput::planes);
    ASSERT_EQ(values.results().size(), 4u);
    GraphValues::Scratch scratch = values.make_scratch();
    for (const Vec3d& p : random_points(100, 1.2, 8)) {
        for (int axis = 0; axis < 3; ++axis) scratch[Register(axis)][0] = p[axis];
        values.program().run(1, scratch);
        const GraphSample sample = GraphEvaluator(graph)(p);
        for (std::size_t c = 0; c < 4; ++c)
            EXPECT_NEAR(*scratch[values.results()[c]], sample.channels[c].value, 1e-14);
    }
}

}  // namespace
}  // namespace burl
