// Images at a mesh's own texture coordinates: filtered over a texel as the triangle's map shows it,
// against the mean of 64 x 64 samples of the texel.
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/pipeline/pipeline.h"
#include "atlas/base/json.h"
#include "procedural/graph/json.h"
#include "tests/app/pipeline/mask_cases.h"

namespace burl {
namespace {

/// Blotches two pixels wide, a third of them transparent.
std::shared_ptr<const MipImage> blotches() {
    std::mt19937 random(7);
    Image<Rgba8> image(64, 64);
    for (std::size_t y = 0; y < 64; y += 2)
        for (std::size_t x = 0; x < 64; x += 2) {
            const Rgba8 one{std::uint8_t(random()), std::uint8_t(random()), std::uint8_t(random()),
                            std::uint8_t(random() % 3 == 0 ? 0 : 255)};
            image(x, y) = image(x + 1, y) = image(x, y + 1) = image(x + 1, y + 1) = one;
        }
    return std::make_shared<const MipImage>(image, ImageWrap::repeat);
}

constexpr double base_grey = 0.5;

/// The settings of a filter, "trapezoid" or "supersample:16", before `more`.
std::vector<std::string> with_filter(const std::string& filter, std::vector<std::string> more) {
    const std::size_t colon = filter.find(':');
    more.insert(more.begin(), "filter.kind=" + filter.substr(0, colon));
    if (colon != std::string::npos)
        more.insert(more.begin() + 1, "filter.samples=" + filter.substr(colon + 1));
    return more;
}

Recipe decal_recipe(const std::shared_ptr<const MipImage>& image, const char* lookup,
                    const std::string& filter) {
    Recipe recipe = mask_recipe(
        R"({"node": "constant", "value": 0})",
        with_filter(filter, {"solid.space=object", "solid.scale=3", "solid.rotate=[20,0,0]",
                             "atlas.size=64", "atlas.kind=patch"}));
    recipe.texture = graph_from_json(
        nlohmann::ordered_json::parse(fmt::format(
            R"({{"node": "layer_over", "base": {}, "top": {{"node": "mesh_uv", "input":
                {{"node": "image", "file": "i.png", "lookup": "{}"}}}}}})",
            base_grey, lookup)),
        [&](const std::string&, ImageWrap) { return image; });
    return recipe;
}

/// The colour at texture coordinates, without a footprint.
Vec3d color_at(const MipImage& image, const Vec2d& uv) {
    const Vec3d color = image.bilinear(0, uv.x, uv.y).color;
    const double alpha = image.alpha()->bilinear(0, uv.x, uv.y).color.x;
    return color + (1.0 - alpha) * Vec3d(base_grey);
}

/// The texture coordinates of a point of the sheet: four repeats along x, one along y, slanted.
Vec2d coordinates_at(const Vec3d& p) {
    return {2.0 * p.x + 0.3 * p.y, 0.6 * p.y - 0.2 * p.x};
}

Mesh slanted_sheet() {
    Mesh mesh = made::sheet({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle)
            mesh.corners.uvs.push_back(coordinates_at(mesh.positions[corner]));
    add_whole_part(mesh);
    return mesh;
}

/// The mean of 64 x 64 samples of a texel.
Vec3d truth_at(const MipImage& image, const TexelMap& map, std::uint32_t x, std::uint32_t y) {
    Vec3d sum(0.0);
    for (int j = 0; j < 64; ++j)
        for (int i = 0; i < 64; ++i) {
            const double u = (i + 0.5) / 64.0 - 0.5, v = (j + 0.5) / 64.0 - 0.5;
            sum += color_at(image, coordinates_at(map(x, y) + u * map.step_x + v * map.step_y));
        }
    return sum / 4096.0;
}

/// The root mean square of the texels' errors.
double decal_error(const char* lookup, const std::string& filter) {
    const auto image = blotches();
    Pipeline pipeline(slanted_sheet());
    pipeline.set_recipe(decal_recipe(image, lookup, filter));
    const Image<RgbF> picture = pipeline.synthesize<RgbF>();
    const SolidAtlas& solid = pipeline.solid();
    double sum = 0.0;
    std::size_t texel = 0, count = 0;
    for (std::uint32_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                // Gutters show the sheet's sides.
                const Vec3d p = solid.maps[span.map](x, y);
                if (++texel % 31 != 0 || glm::min(p.x, p.y) < 0.1 || glm::max(p.x, p.y) > 1.9)
                    continue;
                const Vec3d off = Vec3d(picture(x, y).r, picture(x, y).g, picture(x, y).b) -
                                  truth_at(*image, solid.maps[span.map], x, y);
                sum += glm::dot(off, off) / 3.0;
                ++count;
            }
    EXPECT_GT(count, 50u);
    return std::sqrt(sum / double(count));
}

TEST(Decals, AreFilteredOverTheirTexels) {
    const double points = decal_error("trilinear", "none");
    const double trilinear = decal_error("trilinear", "trapezoid");
    const double ewa = decal_error("ewa", "trapezoid");
    const double samples = decal_error("trilinear", "supersample:16");
    for (const auto& [name, error] :
         {std::pair("points", points), std::pair("trilinear", trilinear), std::pair("ewa", ewa),
          std::pair("samples", samples)})
        RecordProperty(name, fmt::format("{:.4f}", error));
    EXPECT_GT(points, 0.1);
    EXPECT_LT(trilinear, 0.95 * points);
    EXPECT_LT(ewa, 0.7 * points);
    EXPECT_LT(ewa, trilinear);
    EXPECT_LT(samples, 0.6 * points);
}

TEST(Decals, PicturesOfMaterialsAreFilteredAlike) {
    const auto image = blotches();
    for (const char* filter : {"trapezoid", "supersample:4"}) {
        Pipeline pipeline(slanted_sheet());
        pipeline.set_recipe(decal_recipe(image, "ewa", filter));
        const Image<RgbF> picture = pipeline.synthesize<RgbF>();
        PicturePlan plan;
        for (std::size_t c = 0; c < 3; ++c) plan.components[c].plane = c;
        const auto pictures = pipeline.pictures<RgbaF>({plan});
        const SolidAtlas& solid = pipeline.solid();
        for (std::uint32_t y = 0; y < solid.size; ++y)
            for (const Span& span : solid.row(y))
                for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                    ASSERT_NEAR(picture(x, y).g, pictures[0](x, y).g, 1e-6) << filter;
    }
}

TEST(Decals, StepsOfMasksAreSoftenedByFiltersAndSamples) {
    // A step of red, x / 2, at x = 1: a texel on it shows the share of its samples beyond.
    const char* const step = R"({"node": "color_map", "wrap": "clamp",
        "stops": [[0, "#000000"], [0.5, "#000000"], [0.5, "#ffffff"], [1, "#ffffff"]],
        "input": {"node": "split", "input": {"node": "vertex_color"}}})";
    for (const char* filter : {"none", "trapezoid", "supersample:16"}) {
        Pipeline pipeline(drawn_sheet());
        pipeline.set_recipe(
            mask_recipe(step, with_filter(filter, {"solid.space=object", "atlas.size=64"})));
        std::size_t between = 0, white = 0, black = 0;
        const Image<RgbF> picture = pipeline.synthesize<RgbF>();
        for (const RgbF& texel : picture.pixels()) {
            between += texel.g > 0.01f && texel.g < 0.99f;
            white += texel.g >= 0.99f;
            black += texel.g <= 0.01f;
        }
        EXPECT_GT(std::min(white, black), 500u) << filter;
        if (filter == std::string("none"))
            EXPECT_EQ(between, 0u);
        else
            EXPECT_GT(between, 20u) << filter;
    }
}

}  // namespace
}  // namespace burl
