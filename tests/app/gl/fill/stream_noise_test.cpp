// The noise of shaders/noise/stream_noise.glsl over random lattice coordinates against the host's
// kernels, bit by bit.
#include <random>

#include <gtest/gtest.h>

#include "app/gl/device/objects.h"
#include "app/gl/device/target.h"
#include "procedural/glsl/field.h"
#include "procedural/kernels/simplex_kernel.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {
namespace {

constexpr GlSize map_size(32, 32);
constexpr std::size_t texel_count = 1024;
static_assert(texel_count <= batch_capacity);

/// Cells below 2^cell_bits on both sides of 0, and what lies at a cell's borders and in its middle.
LatticeStream random_stream(int cell_bits) {
    std::mt19937 random(7);
    LatticeStream stream;
    for (std::size_t j = 0; j < texel_count; ++j)
        for (int axis = 0; axis < 3; ++axis) {
            const auto cell = std::int32_t(random()) >> (32 - cell_bits);
            const std::uint32_t special[] = {0u, 1u, 0x7fffffffu, 0x80000000u, 0xffffffffu};
            stream.cells[axis][j] = std::uint32_t(cell);
            stream.places[axis][j] = j % 16 == 0 ? special[random() % 5] : std::uint32_t(random());
        }
    return stream;
}

OctaveGroup group_of(NoiseKind kind, Fade fade, double radius2, int octaves) {
    OctaveGroup group;
    group.kind = kind, group.fade = fade, group.radius2 = radius2;
    group.scale = 1.0 / stream_unit(kind);
    for (int k = 0; k < octaves; ++k)
        group.octaves.push_back(
            {k == 0 ? 0u : 0x9e3779b9u * std::uint32_t(k), k, float(std::ldexp(1.1, -k)), radius2});
    return group;
}

FieldOctaves stream_noise_octaves_of(const OctaveGroup& group) {
    FieldOctaves octaves{Texture()};
    octaves.groups.push_back(group);
    return octaves;
}

std::vector<float> host_sums(const OctaveGroup& group, const LatticeStream& stream) {
    alignas(64) static float sums[batch_capacity + batch_padding];
    std::fill(std::begin(sums), std::end(sums), 0.0f);
    for (std::size_t k = group.octaves.size(); k-- > 0;)
        if (group.kind == NoiseKind::simplex)
            simplex_kernel(false)(group.octaves[k], stream, nullptr, texel_count, sums, nullptr);
        else
            direct_kernel(group.kind, group.fade)(group.octaves[k], stream, nullptr, texel_count,
                                                  sums, nullptr);
    return {sums, sums + texel_count};
}

class GlStreamNoiseTest : public GlTest {
  protected:
    GlTexture upload(const std::uint32_t (&numbers)[3][batch_capacity + batch_padding]) {
        std::vector<glm::uvec4> texels;
        for (std::size_t j = 0; j < texel_count; ++j)
            texels.emplace_back(numbers[0][j], numbers[1][j], numbers[2][j], 0u);
        return make_texture(context->gl(), GL_RGBA32UI, map_size,
                            std::span<const glm::uvec4>(texels));
    }

    std::vector<float> drawn_sums(const OctaveGroup& group, const LatticeStream& stream) {
        const GladGLContext& gl = context->gl();
        ShaderSource source;
        source.define_real(true);
        const FieldOctaves octaves = stream_noise_octaves_of(group);
        for (const GlslPart& part : glsl_field(octaves.shape()))
            if (part.text.empty())
                source.add(part.name);
            else
                source.add(part.name, part.text);
        source.add("main",
                   "layout(location = 0) out float sum;\n"
                   "void main() { sum = float(field(ivec2(gl_FragCoord.xy))); }\n");
        const GlProgram program = make_full_screen_program(gl, "noise", source);
        const FieldUniforms uniforms = octaves.uniforms();
        const GlTexture cells = upload(stream.cells), places = upload(stream.places);
        const GlTarget target(gl, map_size, {GL_R32F});
        program.use();
        bind_texture(gl, 0, cells);
        bind_texture(gl, 1, places);
        program.set("map_cells[0]", 0);
        program.set("map_places[0]", 1);
        program.set("map_scale", 1.0f / glm::vec2(map_size));
        program.set("constant", 0.0);
        program.set("scales[0]", 1.0);
        const auto count = GLsizei(uniforms.seeds.size());
        gl.Uniform3uiv(program.uniform("seeds"), count, uniforms.seeds[0].data());
        gl.Uniform1fv(program.uniform("weights"), count, uniforms.weights.data());
        program.set("radii[0]", uniforms.radii[0]);
        target.bind();
        GlFullScreen(gl).draw();
        return target.read<float>();
    }

    void expect_equal(const OctaveGroup& group, int cell_bits) {
        const LatticeStream stream = random_stream(cell_bits);
        const std::vector<float> host = host_sums(group, stream), drawn = drawn_sums(group, stream);
        std::size_t different = 0;
        double sizes = 0.0;
        for (std::size_t j = 0; j < texel_count; ++j) {
            different += host[j] == drawn[j] ? 0 : 1;
            sizes += std::abs(double(host[j]));
        }
        EXPECT_EQ(different, 0u) << int(group.kind) << " " << int(group.fade);
        EXPECT_GT(sizes, 0.0);
    }
};

TEST_F(GlStreamNoiseTest, ValueNoiseHasTheHostsBits) {
    for (const Fade fade : {Fade::linear, Fade::smooth, Fade::quintic})
        expect_equal(group_of(NoiseKind::value, fade, 0.0, 4), 32);
}

TEST_F(GlStreamNoiseTest, PerlinNoiseHasTheHostsBits) {
    expect_equal(group_of(NoiseKind::perlin, Fade::quintic, 0.0, 4), 32);
}

TEST_F(GlStreamNoiseTest, SimplexNoiseHasTheHostsBits) {
    expect_equal(group_of(NoiseKind::simplex, Fade::smooth, 0.6, 3), 19);
    expect_equal(group_of(NoiseKind::simplex, Fade::smooth, 0.5, 1), 19);
}

TEST_F(GlStreamNoiseTest, TheMostDoublingsKeepTheHostsBits) {
    OctaveGroup group = group_of(NoiseKind::value, Fade::quintic, 0.0, int(most_doublings) + 1);
    expect_equal(group, 32);
}

}  // namespace
}  // namespace burl
