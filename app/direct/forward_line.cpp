#include "app/direct/forward_line.h"

#include <algorithm>
#include <cmath>

#include "procedural/bresenham/field.h"

namespace burl {

namespace {

constexpr double texel_step = 2.0 / double(line_texels);

LatticeLine solid_line() {
    return {Vec3d(0.0), Vec3d(texel_step), 0.0, line_texels};
}

constexpr Rgb8 paper{255, 255, 255}, zero{200, 200, 200}, dashes{130, 160, 220},
    light_curve{240, 170, 90}, dark_curve{0, 0, 0};

}  // namespace

std::vector<double> noise_on_line(std::span<const Octave> octaves, CubeMethod method) {
    std::vector<double> values(line_texels, 0.0);
    const LatticeLine line = solid_line();
    const ForwardOptions never_anew{ForwardPrecision::float32, std::int64_t(1) << 62};
    if (method == CubeMethod::forward)
        forward_octaves({}, octaves, line, never_anew, values.data());
    else
        for (std::size_t j = 0; j < line_texels; ++j)
            values[j] = evaluate_field({}, octaves, double(j) * line.step);
    return values;
}

std::vector<std::size_t> cell_entries(const Octave& octave) {
    std::vector<std::size_t> entries;
    Vec3d before(0.0);
    for (std::size_t j = 0; j < line_texels; ++j) {
        const Vec3d cell = glm::floor(octave.lattice_from_solid(Vec3d(double(j) * texel_step)));
        if (j == 0 || cell != before) entries.push_back(j);
        before = cell;
    }
    return entries;
}

LinePlot::LinePlot(double largest) : largest_(largest), picture_(width, height, paper) {
    for (std::size_t x = left; x < left + line_texels; ++x) picture_(x, middle) = zero;
}

std::size_t LinePlot::row_of(double value) const {
    const double up = std::clamp(value / largest_, -1.0, 1.0) * reach;
    return std::size_t(double(middle) - std::round(up));
}

void LinePlot::dash(std::size_t texel) {
    for (std::size_t y = 0; y < height; ++y)
        if (y % 6 < 3) picture_(left + texel, y) = dashes;
}

/// Draws each value with a stroke to the one before, and `more` pixels above and below.
void LinePlot::add(std::span<const double> values, std::size_t more, const Rgb8& color) {
    for (std::size_t j = 0; j < values.size(); ++j) {
        const std::size_t here = row_of(values[j]), before = row_of(values[j > 0 ? j - 1 : 0]);
        // The stroke's half that is nearer to this value.
        const std::size_t half = (here + before) / 2;
        const auto [low, high] = std::minmax(here, half);
        for (std::size_t y = low - more; y <= high + more; ++y) picture_(left + j, y) = color;
    }
}

void LinePlot::add_broad(std::span<const double> values) {
    add(values, 2, light_curve);
}

void LinePlot::add_thin(std::span<const double> values) {
    add(values, 0, dark_curve);
}

}  // namespace burl
