#include "app/pipeline/measure_synthesis.h"

#include <algorithm>

#include "app/base/stopwatch.h"
#include "app/pipeline/fill_texture.h"

namespace burl {

namespace {

/// The square x, y in [-0.5, 0.5), z = 0.01, with one span per row.
SolidAtlas square(std::uint32_t side) {
    SolidAtlas solid;
    solid.size = side;
    const double step = 1.0 / side;
    solid.maps.push_back({Vec3d(-0.5, -0.5, 0.01), Vec3d(step, 0.0, 0.0), Vec3d(0.0, step, 0.0)});
    for (std::uint32_t y = 0; y < side; ++y) {
        solid.row_begin.push_back(y);
        solid.spans.push_back({0, side, 0});
    }
    solid.row_begin.push_back(side);
    return solid;
}

/// The least seconds of three runs, after one run that is not timed.
template <class Work>
double least_seconds(const Work& work) {
    work();
    double least = 0.0;
    for (int i = 0; i < 3; ++i) {
        double seconds = 0.0;
        timed(seconds, work);
        least = i == 0 ? seconds : std::min(least, seconds);
    }
    return least;
}

}  // namespace

SynthesisSeconds measure_synthesis(TextureSynthesizer& synthesizer, const Recipe& recipe,
                                   std::uint32_t side) {
    Image<Rgb8> image(side, side);
    const SynthesisSeconds seconds = measure_synthesis(
        recipe, [&](const SolidAtlas& solid) { synthesizer.synthesize(solid, recipe, 0, &image); },
        side);
    synthesizer.forget_atlas();
    return seconds;
}

SynthesisSeconds measure_synthesis(const Recipe& recipe,
                                   const std::function<void(const SolidAtlas&)>& other,
                                   std::uint32_t side) {
    const SolidAtlas solid = square(side);
    Image<Rgb8> image;
    SynthesisSeconds seconds;
    seconds.host = least_seconds([&] { image = fill_texture<Rgb8>(solid, recipe, HostWay{}); });
    seconds.other = least_seconds([&] { other(solid); });
    return seconds;
}

}  // namespace burl
