#include "procedural/glsl/simplex.h"

#include <cmath>

#include <fmt/format.h>

#include "procedural/noise/simplex_curl.h"

namespace burl {

namespace {

/// The expression of type SimplexLattice.
std::string lattice_text(std::size_t dimensions, const GlslFunctions& functions) {
    constexpr std::array stretches{SimplexShape<2>::stretch, SimplexShape<3>::stretch,
                                   SimplexShape<4>::stretch, SimplexShape<5>::stretch,
                                   SimplexShape<6>::stretch, SimplexShape<7>::stretch,
                                   SimplexShape<8>::stretch};
    const double stretch = stretches[dimensions - least_simplex_dimensions];
    const auto in_float = [](double x) { return glsl_number(x, GlslReal::float32); };
    return fmt::format("SimplexLattice({}, {}, {}, {})", dimensions, functions.number(stretch),
                       in_float((1.0 - 1.0 / stretch) / double(dimensions)),
                       in_float(simplex_units[dimensions]));
}

/// The expression of type SimplexNoise.
std::string noise_text(const SimplexNoise& noise, const GlslFunctions& functions) {
    return fmt::format("SimplexNoise({}, {}, {})", lattice_text(noise.dimensions, functions),
                       int(noise.signal), functions.number(noise.turn()));
}

/// The expression of type OctaveLadder, weights times `amplitude`.
std::string ladder_text(const OctaveLadder& ladder, double amplitude,
                        const GlslFunctions& functions) {
    return fmt::format("OctaveLadder({}u, {}, {}, {}, {})", ladder.seed, int(ladder.octaves),
                       functions.number(ladder.lacunarity), functions.number(ladder.gain),
                       functions.number(amplitude));
}

/// The expression of an array of eight items, the inputs and then `rest`.
std::string array_text(const char* type, std::vector<std::string> inputs, const std::string& rest) {
    inputs.resize(most_simplex_dimensions, rest);
    for (std::string& input : inputs) input = fmt::format("to_item({})", input);
    return fmt::format("{}[{}]({})", type, inputs.size(), fmt::join(inputs, ", "));
}

std::string arguments(const SimplexOctaves& octaves, const GlslFunctions& functions) {
    return fmt::format("{}, {}", noise_text(octaves.noise, functions),
                       ladder_text(octaves.octaves, octaves.noise.amplitude(), functions));
}

std::string arguments(const CurlOctaves& octaves, const GlslFunctions& functions) {
    const std::size_t dimensions = octaves.time ? 4 : 3;
    return fmt::format("{}, {}, {}", lattice_text(dimensions, functions),
                       ladder_text(octaves.octaves, simplex_curl_amplitude(dimensions), functions),
                       functions.number(octaves.time.value_or(0.0)));
}

void need_values(GlslFunctions& functions) {
    functions.need("noise/simplex_signal.glsl");
}

void need_duals(GlslFunctions& functions) {
    need_values(functions);
    functions.need("graph/dual_simplex.glsl");
}

}  // namespace

std::string glsl_simplex_sum(const SimplexOctaves& octaves, const std::vector<std::string>& inputs,
                             GlslFunctions& functions) {
    need_values(functions);
    return fmt::format("simplex_octaves({}, {})", arguments(octaves, functions),
                       array_text("real_item", inputs, functions.number(0.0)));
}

std::string glsl_curl_sum(const CurlOctaves& octaves, const std::vector<std::string>& inputs,
                          GlslFunctions& functions) {
    need_values(functions);
    return fmt::format("curl_octaves({}, real3({}))", arguments(octaves, functions),
                       fmt::join(inputs, ", "));
}

std::string glsl_dual_simplex_sum(const SimplexOctaves& octaves,
                                  const std::vector<std::string>& inputs,
                                  const std::array<std::string, 2>& steps,
                                  GlslFunctions& functions) {
    need_duals(functions);
    const SimplexNoise& noise = octaves.noise;
    const bool waves = noise.signal == SimplexSignal::wave;
    return fmt::format("dual_simplex_octaves({}, {}, {}, {}, {})", arguments(octaves, functions),
                       functions.number(waves ? std::max(noise.waves, 1.0) : 1.0),
                       array_text("real4_item", inputs, "real4(0.0)"), steps[0], steps[1]);
}

std::string glsl_dual_curl_sum(const CurlOctaves& octaves, const std::vector<std::string>& inputs,
                               const std::array<std::string, 2>& steps, GlslFunctions& functions) {
    need_duals(functions);
    return fmt::format("dual_curl_octaves({}, {}, {}, {})", arguments(octaves, functions),
                       array_text("real4_item", inputs, "real4(0.0)"), steps[0], steps[1]);
}

}  // namespace burl
