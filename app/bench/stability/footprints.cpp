// Texels with large footprints for filters: equally large in all directions, and 1000 times longer
// than wide.
#include <fmt/format.h>

#include "app/bench/stability/cases.h"
#include "app/bench/stability/chance.h"
#include "app/bench/stability/noise.h"

namespace burl {

StabilityGroup filter_group(StabilityChoice choice) {
    StabilityGroup group{"filters", {}};
    const bool few = choice == StabilityChoice::thinned;
    for (const NamedTerm& noise : named_terms())
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
            for (const double step : {1e-6, 1e-3, 1.0 / 64, 1.0 / 8, 1.0, 30.0})
                for (const double ratio : {1.0, 1e-3}) {
                    const NoiseSpec spec{.kind = noise.term.kind, .radius2 = noise.term.radius2};
                    if (has_jumps(spec)) continue;
                    if (few && (!has_long_form(spec) || ratio < 1.0 || step > 1.0)) continue;
                    Chance chance(std::uint32_t(group.cases.size()));
                    NoiseTerm term = noise.term;
                    term.octaves = 1 + chance.bits() % 4;
                    Texture texture = texture_of(term);
                    texture.colors.wrap = wrap;
                    const double place = chance.pick(std::array{0.3, -17.3, 1e3 + 0.7});
                    texture.quadric.a = chance.signed_unit() / place, texture.quadric.g = 0.5;
                    SolidAtlas solid = random_lines(Vec3d(place), step, few ? 8 : 24, 4,
                                                    std::uint32_t(group.cases.size()));
                    for (TexelMap& map : solid.maps) map.step_y = ratio * step * chance.vector();
                    group.cases.push_back(
                        {fmt::format("{}, {} octaves near {:g}, texels of {:g} by {:g} cells, {}",
                                     noise.name, term.octaves, place, step, step * ratio,
                                     to_string(wrap)),
                         texture, std::move(solid)});
                }
    return group;
}

}  // namespace burl
