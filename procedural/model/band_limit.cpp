// Means of octaves are computed once per texture.
#include "procedural/model/band_limit.h"

#include "procedural/noise/noise.h"

namespace burl {

double octave_mean(const Octave& octave) {
    const bool symmetric = octave.shape == OctaveShape::plain && !is_distance(octave.noise.kind);
    if (symmetric) return 0.0;
    constexpr int side = 12;
    double sum = 0.0;
    for (int i = 0; i < side * side * side; ++i) {
        const double x = i % side, y = i / side % side, z = i / (side * side);
        // Multiples of three irrational numbers spread the points over the cells.
        const Point<3> p{x + std::fmod(0.5 + i * 0.8191725134, 1.0),
                         y + std::fmod(0.5 + i * 0.6710436067, 1.0),
                         z + std::fmod(0.5 + i * 0.5497004779, 1.0)};
        sum += shaped(octave.shape, sample_noise<double, 3>(octave.noise, p)).value;
    }
    return octave.scale * sum / (side * side * side);
}

}  // namespace burl
