// Random recipes of the size of the papers' textures: |q| <= 1, and amplitudes with the sum 2.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tests/stability/cases.h"
#include "tests/stability/truth.h"

namespace burl {

namespace {

/// Returns a quadric with random coefficients, scaled so that |q| <= 1 on the lines.
Quadric unit_quadric(Chance& chance, const SolidAtlas& solid) {
    Texture texture;
    Quadric& q = texture.quadric;
    const auto coefficients = {&q.a, &q.b, &q.c, &q.d, &q.e, &q.f, &q.g, &q.h, &q.i, &q.j};
    for (double* c : coefficients) *c = chance.signed_unit();
    const StabilityTruth truth(texture, {});
    double most = 0.0;
    for (std::uint32_t y = 0; y < solid.spans.size(); ++y)
        most = std::max(most, truth.sizes(solid.spans[y], solid.maps[y], y).quadric);
    for (double* c : coefficients) *c /= most;
    return q;
}

NoiseTerm random_term(Chance& chance, const std::vector<NamedTerm>& kinds) {
    NoiseTerm term = kinds[chance.bits() % kinds.size()].term;
    if (chance.bits() % 2) term.range = NoiseRange(chance.bits() % 2);
    term.frequency = 4.0 * chance.vector();
    if (chance.bits() % 2) term.phase = 10.0 * chance.vector();
    if (chance.bits() % 3 == 0) {
        term.matrix.emplace();
        for (double& m : *term.matrix) m = 3.0 * chance.signed_unit();
    }
    term.seed = chance.bits();
    if (term.octaves > 1) term.octaves = 1 + chance.bits() % 12;
    term.lacunarity = chance.pick(std::array{2.0, 2.0, 1.0, 1.9, 2.17, 0.5});
    term.gain = chance.pick(std::array{0.5, 0.5, 0.7, 1.0 / 3.0, 1.0, 1.5});
    term.amplitude = chance.signed_unit();
    return term;
}

/// Removes octaves so far out that float64 itself rounds their coordinates.
void leave_out_far_octaves(Texture& texture, const SolidAtlas& solid) {
    for (NoiseTerm& term : texture.noise) {
        Texture one;
        one.noise = {term};
        const auto cells = [&] {
            const StabilityTruth truth(one, {});
            double most = 0.0;
            for (std::uint32_t y = 0; y < solid.spans.size(); ++y)
                most = std::max(most, truth.sizes(solid.spans[y], solid.maps[y], y).lattice);
            return most;
        };
        for (; term.octaves > 1 && cells() > 1e7; one.noise = {term}) --term.octaves;
    }
}

}  // namespace

StabilityGroup unit_group(StabilityChoice choice) {
    StabilityGroup group{unit_group_name, {}};
    std::vector<NamedTerm> kinds = named_terms();
    std::erase_if(kinds, [](const NamedTerm& one) {
        return one.term.kind == NoiseKind::white ||
               StabilityTruth(texture_of(one.term), {}).special_errors() > 0.0;
    });
    const std::uint32_t count = choice == StabilityChoice::thinned ? 30
                                : choice == StabilityChoice::usual ? 400
                                                                   : 6000;
    for (std::uint32_t seed = 0; seed < count; ++seed) {
        Chance chance(seed);
        const double far = chance.pick(std::array{0.0, 1.0, 1e2, 1e4, 1e6}),
                     step = chance.pick(std::array{1e-4, 1.0 / 256, 1.0 / 16, 0.5, 2.0});
        const SolidAtlas solid = random_lines(far * chance.vector(), step, 64, 8, seed);
        Texture texture = texture_of({});
        texture.quadric = unit_quadric(chance, solid);
        texture.noise.clear();
        for (std::uint32_t i = 0; i < 1 + seed % 3; ++i)
            texture.noise.push_back(random_term(chance, kinds));
        leave_out_far_octaves(texture, solid);
        const double amplitudes = StabilityTruth(texture, {}).amplitudes();
        for (NoiseTerm& term : texture.noise) term.amplitude *= 2.0 / amplitudes;
        group.cases.push_back(
            {fmt::format("recipe {} near {:g}, texels of {:g}", seed, far, step), texture, solid});
    }
    return group;
}

}  // namespace burl
