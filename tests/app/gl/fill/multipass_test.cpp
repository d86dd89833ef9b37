// Multipass noise on OpenGL against the host's model, pass by pass.
#include "app/gl/fill/multipass.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "procedural/noise/value_noise.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/procedural/passes/model.h"

namespace burl {
namespace {

constexpr int pass_side = 64;

/// Cells from -5 on, oblique to the lattice.
LatticeMap slice() {
    return lattice_slice(
        pass_side, pass_side,
        {Mat3d(0.17, 0.031, -0.05, -0.027, 0.21, 0.013, 0, 0, 1), Vec3d(-4.3, 0.2, 2.7)});
}

LatticeBox box() {
    const Vec3d low(-6.1, 0.0, -0.7), high(6.8, 15.9, 3.9);
    return {low, high};
}

std::vector<MultipassOctave> octaves_of(Fade fade, int count) {
    std::vector<MultipassOctave> octaves;
    for (int k = count; k-- > 0;) {
        MultipassOctave octave;
        octave.fade = fade, octave.seed = std::uint32_t(k), octave.doublings = k;
        octave.scale = std::ldexp(0.5, -k);
        octave.bits = lattice_bits(box(), k);
        octaves.push_back(octave);
    }
    return octaves;
}

GlLatticeMap upload(const GladGLContext& gl, const LatticeMap& map) {
    GlTarget target(gl, {pass_side, pass_side}, {GL_RGBA32UI, GL_RGBA32UI});
    for (const auto& [number, image] : {std::pair(0u, &map.cells), std::pair(1u, &map.places)}) {
        gl.BindTexture(GL_TEXTURE_2D, target.texture(number).get());
        gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, pass_side, pass_side, GL_RGBA_INTEGER,
                         GL_UNSIGNED_INT, image->pixels().data());
    }
    check_gl(gl, "uploading a slice");
    return GlLatticeMap(std::move(target));
}

struct Case {
    const char* name;
    MultipassOptions options;
    Fade fade = Fade::smooth;
};

/// How this OpenGL rounds what it draws into half floats: 1 + 3/2^12 lies between 1 and 1 + 4/2^12,
/// which is the nearer of the two.
HalfRounding half_rounding(const GladGLContext& gl) {
    const GlTarget target(gl, {1, 1}, {GL_RGBA16F});
    const GlProgram program = make_full_screen_program(
        gl, "a test of rounding",
        ShaderSource().add("rounding",
                           "out vec4 color;\nvoid main() { color = vec4(1.000732421875); }\n"));
    program.use();
    target.bind();
    GlFullScreen(gl).draw();
    return target.read<float>()[0] == 1.0f ? HalfRounding::toward_zero : HalfRounding::nearest_even;
}

class GlMultipassTest : public GlTest, public testing::WithParamInterface<Case> {};

/// Units of fixed8 are 1/255, else the numbers themselves.
std::vector<PassTexel> numbers_of(const GlTarget& target, PassPrecision precision) {
    std::vector<PassTexel> texels(std::size_t(pass_side * pass_side));
    if (precision == PassPrecision::fixed8) {
        const std::vector<std::uint8_t> read = target.read<std::uint8_t>();
        for (std::size_t i = 0; i < texels.size(); ++i)
            texels[i] = {float(read[4 * i]), float(read[4 * i + 1]), float(read[4 * i + 2])};
    } else {
        const std::vector<float> read = target.read<float>();
        for (std::size_t i = 0; i < texels.size(); ++i)
            texels[i] = {read[4 * i], read[4 * i + 1], read[4 * i + 2]};
    }
    return texels;
}

TEST_P(GlMultipassTest, EveryPassGivesTheModelsImage) {
    const LatticeMap map = slice();
    const MultipassPlan plan =
        plan_multipass(GetParam().options, octaves_of(GetParam().fade, 2), 0.25, Wrap::repeat);
    const GladGLContext& gl = context->gl();
    MultipassModel model(plan, {&map, 1}, half_rounding(gl));
    GlMultipass multipass(gl, has_float64(gl));
    multipass.set_plan(plan, {pass_side, pass_side});
    const GlLatticeMap uploaded = upload(gl, map);
    const std::array maps{&uploaded};
    const PassPrecision precision = plan.options.precision;
    for (std::size_t i = 0; i < plan.passes.size(); ++i) {
        const std::span pass(&plan.passes[i], 1);
        model.run(pass);
        multipass.run(maps, pass);
        const PassImage image = pass[0].target;
        if (holds_integers(image, precision)) {
            const std::vector<std::uint32_t> read = multipass.image(image).read<std::uint32_t>();
            for (std::size_t j = 0; j < model.integers(image).size(); ++j)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    ASSERT_EQ(read[4 * j + axis], model.integers(image)[j][axis]) << i;
        } else {
            ASSERT_EQ(numbers_of(multipass.image(image), precision), model.image(image))
                << "pass " << i << ", kind " << int(pass[0].kind);
        }
    }
}

constexpr Case cases[] = {
    {"float32_hash", {PassPrecision::float32, Randomizer::hash}},
    {"float32_hash_linear", {PassPrecision::float32, Randomizer::hash}, Fade::linear},
    {"float32_table", {PassPrecision::float32, Randomizer::table}},
    {"float16_hash", {PassPrecision::float16, Randomizer::hash}},
    {"float16_table", {PassPrecision::float16, Randomizer::table}},
    {"fixed8_hash", {PassPrecision::fixed8, Randomizer::hash}},
    {"fixed8_table", {PassPrecision::fixed8, Randomizer::table}},
    {"fixed8_bits", {PassPrecision::fixed8, Randomizer::bits}},
    {"fixed8_bits_equalized", {PassPrecision::fixed8, Randomizer::bits, true}, Fade::linear},
};
INSTANTIATE_TEST_SUITE_P(Forms, GlMultipassTest, testing::ValuesIn(cases),
                         [](const auto& form) { return std::string(form.param.name); });

}  // namespace
}  // namespace burl
