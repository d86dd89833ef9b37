// The noises of shaders/noise/ against the host's, bit for bit, at points anywhere.
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include <fmt/format.h>
#include <glad/gl.h>

#include "app/gl/device/objects.h"
#include "app/gl/device/target.h"
#include "procedural/glsl/noise.h"
#include "procedural/kernels/noise_sum.h"
#include "procedural/noise/noise.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {
namespace {

struct NoiseCase {
    const char* name;
    NoiseSpec noise;
};

void PrintTo(const NoiseCase& c, std::ostream* out) {
    *out << c.name;
}

class GlNoise : public GlTest, public testing::WithParamInterface<NoiseCase> {
  protected:
    static constexpr GlSize size{64, 32};
    static constexpr std::size_t count = 64 * 32;

    /// Near and far, on lattice planes, in the middle of cells, outside the lattice.
    static std::vector<Point<3>> make_points() {
        std::mt19937_64 random(7);
        const auto uniform = [&] { return std::uniform_real_distribution(-1.0, 1.0)(random); };
        const auto coordinate = [&]() -> double {
            switch (random() % 8) {
                case 0:
                    return std::floor(20.0 * uniform());
                case 1:
                    return std::floor(20.0 * uniform()) + 0.5;
                case 2:
                    return 1e6 * uniform();
                case 3:
                    return 0x1p33 * uniform();
                case 4:
                    return 0x1p51 * uniform();
                default:
                    return 8.0 * uniform();
            }
        };
        std::vector<Point<3>> points(count);
        for (Point<3>& p : points) p = {coordinate(), coordinate(), coordinate()};
        points[0][0] = points[1][1] = std::numeric_limits<double>::quiet_NaN();
        points[2][2] = 0x1p51, points[3][0] = -1e300, points[4][1] = -1e-20;
        return points;
    }

    /// Float64 bits of two coordinates, of which the second may be left out.
    GlTexture upload(std::size_t first, std::size_t second) const {
        std::vector<std::uint32_t> texels;
        for (const Point<3>& p : points)
            for (const double x : {p[first], second < 3 ? p[second] : 0.0}) {
                const auto bits = std::bit_cast<std::uint64_t>(x);
                texels.push_back(std::uint32_t(bits));
                texels.push_back(std::uint32_t(bits >> 32));
            }
        return make_texture(context->gl(), GL_RGBA32UI, size,
                            std::span<const std::uint32_t>(texels));
    }

    /// Draws `number(real3 p)` of every point, a float or, `sloped`, a vec4; `functions` define it.
    std::vector<float> draw(const NoiseSpec& noise, const std::string& functions,
                            bool sloped = false) const {
        const GladGLContext& gl = context->gl();
        ShaderSource source;
        source.define_real(true).define("number_type", sloped ? "vec4" : "float");
        add_parts(source, glsl_noise_parts(std::span(&noise, 1)));
        if (sloped) add_parts(source, glsl_gradient_parts(std::span(&noise, 1)));
        source.add("functions", functions);
        source.add("main", R"(
            uniform usampler2D xy, z;
            out number_type result;
            void main() {
                ivec2 at = ivec2(gl_FragCoord.xy);
                uvec4 a = texelFetch(xy, at, 0);
                result = number(dvec3(packDouble2x32(a.xy), packDouble2x32(a.zw),
                                      packDouble2x32(texelFetch(z, at, 0).xy)));
            })");
        const GlProgram program = make_full_screen_program(gl, "noise", source);
        const GlTarget target(gl, size, {sloped ? GLenum(GL_RGBA32F) : GLenum(GL_R32F)});
        const GlTexture xy = upload(0, 1), z = upload(2, 3);
        program.use();
        program.set("xy", 0);
        program.set("z", 1);
        bind_texture(gl, 0, xy);
        bind_texture(gl, 1, z);
        target.bind();
        GlFullScreen(gl).draw();
        std::vector<float> result = target.read<float>();
        check_gl(gl, "drawing noise");
        return result;
    }

    /// A zero's sign may differ.
    static std::size_t differences(const std::vector<float>& a, const std::vector<float>& b) {
        EXPECT_EQ(a.size(), b.size());
        std::size_t different = 0;
        for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
            different += a[i] == b[i] ? 0 : 1;
        return different;
    }

    void expect_host_bits(const NoiseSpec& noise) const {
        std::vector<float> expected;
        for (const Point<3>& p : points) expected.push_back(noise_value<float, 3>(noise, p));
        const std::string functions =
            glsl_site_noise(noise, "site_noise") +
            fmt::format("float number(real3 p) {{ return site_noise({}u, p, {:.17e}lf); }}\n",
                        noise.seed, noise.time.value_or(0.0));
        EXPECT_EQ(differences(draw(noise, functions), expected), 0u);
    }

    const std::vector<Point<3>> points = make_points();
};

TEST_P(GlNoise, AtSitesHasTheHostsBits) {
    expect_host_bits(GetParam().noise);
}

/// Split once, looked at after three doublings too.
TEST_P(GlNoise, AtSplitPointsHasTheKernelsBits) {
    const NoiseSpec& noise = GetParam().noise;
    if (!has_point_kernel(noise)) return;
    alignas(64) double arrays[4][256 + batch_padding] = {};
    NoiseSum sum{noise, OctaveShape::ridged, {{noise.seed, 1.0, 1.0}, {noise.seed, 2.0, 0.5}}, 0.0};
    std::vector<float> expected;
    for (std::size_t first = 0; first < count; first += 256) {
        for (std::size_t j = 0; j < 256; ++j)
            for (std::size_t axis = 0; axis < 3; ++axis) arrays[axis][j] = points[first + j][axis];
        add_up(sum, {arrays[0], arrays[1], arrays[2]}, 256, arrays[3]);
        for (std::size_t j = 0; j < 256; ++j) expected.push_back(float(arrays[3][j]));
    }
    const std::string functions =
        glsl_split_noise(noise, "split_noise") + glsl_octave_shape(OctaveShape::ridged, "ridge") +
        fmt::format(
            "float octave(SplitPoint s, int k) {{\n"
            "    return ridge(split_noise({}u, cells_of(s, k), places_of(s, k)));\n"
            "}}\n"
            "float number(real3 p) {{\n"
            "    exact float sum = 0.5 * octave(split_points(p, 0.5 * lattice_limit), 1);\n"
            "    sum += octave(split_points(p, lattice_limit), 0);\n"
            "    return sum;\n"
            "}}\n",
            noise.seed);
    EXPECT_EQ(differences(draw(noise, functions), expected), 0u);
}

/// Noise and gradient as four floats a point.
TEST_P(GlNoise, GradientsAtSitesHaveTheHostsBits) {
    const NoiseSpec& noise = GetParam().noise;
    std::vector<float> expected;
    for (const Point<3>& p : points) {
        const auto n = sample_noise<float, 3>(noise, p);
        expected.insert(expected.end(), {n.value, n.gradient[0], n.gradient[1], n.gradient[2]});
    }
    const std::string functions =
        glsl_site_noise(noise, "site_sample", true) +
        fmt::format("vec4 number(real3 p) {{ return site_sample({}u, p, {:.17e}lf); }}\n",
                    noise.seed, noise.time.value_or(0.0));
    EXPECT_EQ(differences(draw(noise, functions, true), expected), 0u);
}

TEST_P(GlNoise, GradientsAtSplitPointsHaveTheKernelsBits) {
    const NoiseSpec& noise = GetParam().noise;
    if (!has_point_kernel(noise)) return;
    alignas(64) double arrays[3][256 + batch_padding] = {};
    alignas(64) float sums[5][256 + batch_padding] = {};
    for (std::size_t j = 0; j < 256; ++j) sums[4][j] = float(j) * 0.0078125f;
    const NoiseSum sum{
        noise, OctaveShape::ridged, {{noise.seed, 1.0, 1.0}, {noise.seed, 2.0, 0.3}}, 0.0};
    std::vector<float> expected;
    for (std::size_t first = 0; first < count; first += 256) {
        for (std::size_t j = 0; j < 256; ++j)
            for (std::size_t axis = 0; axis < 3; ++axis) arrays[axis][j] = points[first + j][axis];
        add_up_slopes(sum, {arrays[0], arrays[1], arrays[2]}, 256, {sums[4], 0.25},
                      {sums[0], {sums[1], sums[2], sums[3]}});
        for (std::size_t j = 0; j < 256; ++j)
            expected.insert(expected.end(), {sums[0][j], sums[1][j], sums[2][j], sums[3][j]});
    }
    const std::string functions =
        glsl_split_noise(noise, "split_sample", true) +
        fmt::format(
            "vec4 octave(SplitPoint s, int k, float weight) {{\n"
            "    float kept = float(int(gl_FragCoord.x) + 64 * (int(gl_FragCoord.y) % 4)) *\n"
            "        0.0078125;\n"  // processors need not round a quotient of floats as the host
            "    return ridged_octave(split_sample({}u, cells_of(s, k), places_of(s, k)), weight,\n"
            "        weight * float(1 << k), visible_share(kept, float(k)), 0.25);\n"
            "}}\n"
            "vec4 number(real3 p) {{\n"
            "    exact vec4 sum = octave(split_points(p, 0.5 * lattice_limit), 1, 0.3);\n"
            "    sum += octave(split_points(p, lattice_limit), 0, 1.0);\n"
            "    return sum;\n"
            "}}\n",
            noise.seed);
    EXPECT_EQ(differences(draw(noise, functions, true), expected), 0u);
}

NoiseSpec of(NoiseKind kind, std::uint32_t seed) {
    NoiseSpec noise;
    noise.kind = kind;
    noise.seed = seed;
    return noise;
}
NoiseSpec value_of(Fade fade) {
    NoiseSpec noise = of(NoiseKind::value, 5);
    noise.fade = fade;
    return noise;
}
NoiseSpec worley_of(WorleyFeature feature) {
    NoiseSpec noise = of(NoiseKind::worley, 4000000000u);
    noise.feature = feature;
    return noise;
}
NoiseSpec repeated(NoiseKind kind, const Period<4>& period, std::optional<double> time) {
    NoiseSpec noise = of(kind, 77);
    noise.period = period;
    noise.time = time;
    return noise;
}

INSTANTIATE_TEST_SUITE_P(Kinds, GlNoise,
                         testing::Values(NoiseCase{"linear", value_of(Fade::linear)},
                                         NoiseCase{"smooth", value_of(Fade::smooth)},
                                         NoiseCase{"quintic", value_of(Fade::quintic)},
                                         NoiseCase{"perlin", of(NoiseKind::perlin, 1)},
                                         NoiseCase{"perlin2002", of(NoiseKind::perlin2002, 0)},
                                         NoiseCase{"perlin1985", of(NoiseKind::perlin1985, 12)},
                                         NoiseCase{"simplex", of(NoiseKind::simplex, 3)},
                                         NoiseCase{"worley_f1", worley_of(WorleyFeature::f1)},
                                         NoiseCase{"worley_f2", worley_of(WorleyFeature::f2)},
                                         NoiseCase{"worley_f2_f1", worley_of(WorleyFeature::f2_f1)},
                                         NoiseCase{"cell", of(NoiseKind::cell, 9)},
                                         NoiseCase{"white", of(NoiseKind::white, 9)}),
                         [](const auto& test) { return std::string(test.param.name); });

/// Some axes repeat, after one cell too; 2^30 is the largest period.
INSTANTIATE_TEST_SUITE_P(
    Periods, GlNoise,
    testing::Values(NoiseCase{"value", repeated(NoiseKind::value, {7, 0, 1u << 30, 0}, {})},
                    NoiseCase{"perlin2002", repeated(NoiseKind::perlin2002, {1, 300, 0, 0}, {})},
                    NoiseCase{"perlin1985", repeated(NoiseKind::perlin1985, {5, 2, 3, 0}, {})},
                    NoiseCase{"simplex", repeated(NoiseKind::simplex, {9, 0, 1073741823, 0}, {})},
                    NoiseCase{"worley", repeated(NoiseKind::worley, {1, 2, 0, 0}, {})},
                    NoiseCase{"white", repeated(NoiseKind::white, {3, 0, 1u << 30, 0}, {})}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Times, GlNoise,
    testing::Values(NoiseCase{"value", repeated(NoiseKind::value, {0, 3, 0, 0}, 2.7)},
                    NoiseCase{"perlin", repeated(NoiseKind::perlin, {0, 0, 0, 2}, -1.25)},
                    NoiseCase{"perlin2002", repeated(NoiseKind::perlin2002, {}, 0.1)},
                    NoiseCase{"perlin1985", repeated(NoiseKind::perlin1985, {}, 0.1)},
                    NoiseCase{"simplex", repeated(NoiseKind::simplex, {}, 1e5 / 3.0)},
                    NoiseCase{"worley", repeated(NoiseKind::worley, {0, 0, 4, 1}, 0.6)},
                    NoiseCase{"cell", repeated(NoiseKind::cell, {}, -3.0)},
                    NoiseCase{"white", repeated(NoiseKind::white, {0, 5, 0, 0}, 12.3456789)}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace burl
