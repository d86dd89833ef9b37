#include "app/stability_cases.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <fmt/format.h>

#include "procedural/noise_names.h"

namespace burl {

namespace {

using Cases = std::vector<StabilityCase>;

class Chance {
  public:
    explicit Chance(std::uint32_t seed) : random_(seed) {}
    double signed_unit() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
    Vec3d vector() { return {signed_unit(), signed_unit(), signed_unit()}; }
    std::uint32_t bits() { return std::uint32_t(random_()); }

  private:
    std::mt19937 random_;
};

struct NamedTerm {
    std::string name;
    NoiseTerm term;
};

/// The noises that a bake runs vectorised.
std::vector<NamedTerm> kernel_terms() {
    std::vector<NamedTerm> terms(4);
    const std::array names{"value linear", "value smooth", "value quintic", "perlin"};
    for (std::size_t i = 0; i < terms.size(); ++i) {
        terms[i].name = names[i];
        terms[i].term.kind = i == 3 ? NoiseKind::perlin : NoiseKind::value;
        terms[i].term.fade = Fade(std::min<std::size_t>(i, 2));
        terms[i].term.octaves = 4, terms[i].term.seed = std::uint32_t(i);
    }
    return terms;
}

Texture texture_of(const NoiseTerm& term) {
    Texture texture;
    texture.noise = {term};
    // The same colour at both ends, so that the map has no jump where it repeats.
    texture.colors.stops = {{0.0, {20, 20, 20}}, {0.5, {230, 200, 120}}, {1.0, {20, 20, 20}}};
    return texture;
}

/// Lines of texels within a cell of a place, in random directions.
SolidAtlas random_lines(const Vec3d& place, double step, std::uint32_t count, std::size_t lines,
                        std::uint32_t seed) {
    Chance chance(seed);
    std::vector<TexelLine> result;
    for (std::size_t i = 0; i < lines; ++i)
        result.push_back(
            {place + (i % 2 == 0 ? chance.vector() : Vec3d(0.0)), step * chance.vector(), count});
    return atlas_of_lines(result);
}

/// Every `stride`-th element.
template <class T>
std::vector<T> thinned(const std::vector<T>& all, std::size_t stride) {
    std::vector<T> some;
    for (std::size_t i = 0; i < all.size(); i += stride) some.push_back(all[i]);
    return some;
}

Cases coordinates(bool full) {
    const std::vector<double> sizes{0.0,  5e-324, 1e-310, 1e-30, 1e-16, 1e-8,
                                    1e-3, 0.5,    1.0,    1e3,   1e6,   1e9};
    const std::vector<double> steps{1e-9, 1e-7, 1e-5, 1e-3, 1.0 / 64, 0.25, 1.0, 30.0, 1e3};
    Cases cases;
    for (const NamedTerm& noise : kernel_terms())
        for (const double size : sizes)
            for (const double sign : {1.0, -1.0})
                for (const double step : thinned(steps, full ? 1 : 4)) {
                    const Vec3d place = sign * size * Vec3d(1.0, -0.7, 0.3);
                    cases.push_back({fmt::format("{} near {:g}, {:g} cells per texel", noise.name,
                                                 sign * size, step),
                                     texture_of(noise.term),
                                     random_lines(place, step, 48, full ? 16 : 4,
                                                  std::uint32_t(cases.size()))});
                }
    return cases;
}

/// Lattice coordinates beyond 2^31, where cells wrap, up to the last ones that are not refused.
Cases far_cells(bool full) {
    Cases cases;
    for (const NamedTerm& noise : kernel_terms())
        for (int power = 31; power <= 42; power += full ? 1 : 4)
            for (const double step : {1.0 / 64, 1.0, 1e3}) {
                const double far = std::ldexp(1.0, power);
                cases.push_back(
                    {fmt::format("{} near 2^{}, {:g} cells per texel", noise.name, power, step),
                     texture_of(noise.term),
                     random_lines({far, -far, 0.4 * far}, step, 48, 8, std::uint32_t(power))});
            }
    return cases;
}

/// Lines that start some floats before a lattice plane and cross it float by float, or lie in it,
/// or meet one every eighth texel.
SolidAtlas plane_lines(double plane, Chance& chance) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double up = std::nextafter(plane, infinity) - plane,
                 down = plane - std::nextafter(plane, -infinity), ulp = std::max(up, down);
    std::vector<TexelLine> lines;
    for (int axis = 0; axis < 3; ++axis)
        for (int other = 0; other < 3; ++other) {
            Vec3d start = 5.0 * chance.vector(), step(0.0);
            start[axis] = plane - 8.0 * ulp, step[axis] = ulp;
            lines.push_back({start, step, 17});
            start[other] = plane - 8.0 * ulp, step[other] = ulp;
            lines.push_back({start, step, 17});
            start[axis] = start[other] = plane;
            lines.push_back({start, Vec3d(0.0), 3});
            start[axis] = std::nextafter(plane, other % 2 == 0 ? infinity : -infinity);
            lines.push_back({start, Vec3d(0.0), 3});
            start[axis] = plane - 2.0, step = Vec3d(0.125);
            lines.push_back({start, step, 33});
        }
    return atlas_of_lines(lines);
}

Cases lattice_planes(bool) {
    Chance chance(3);
    Cases cases;
    for (const NamedTerm& noise : kernel_terms())
        for (const double plane : {0.0, 1.0, -1.0, 7.0, -4096.0, 0x1p20, -0x1p30, 0x1p31 - 1.0,
                                   0x1p31, -0x1p31, 0x1p32, 0x1p40})
            cases.push_back({fmt::format("{} across the plane {:g}", noise.name, plane),
                             texture_of(noise.term), plane_lines(plane, chance)});
    return cases;
}

Cases runs(bool full) {
    std::vector<std::uint32_t> lengths{1,  2,  3,   7,    8,    9,    15,  16,
                                       17, 63, 255, 1000, 1023, 1024, 1025};
    if (full) lengths.insert(lengths.end(), {2049, 4096});
    Cases cases;
    for (const NamedTerm& noise : kernel_terms())
        for (const double step : {1e-9, 1e-4, 1.0 / 256, 1.0 / 16, 0.7}) {
            Chance chance(std::uint32_t(cases.size()));
            std::vector<TexelLine> lines;
            for (const std::uint32_t length : lengths)
                lines.push_back({10.0 * chance.vector(), step * chance.vector(), length});
            cases.push_back({fmt::format("{}, runs of 1 to {} texels of {:g} cells", noise.name,
                                         lengths.back(), step),
                             texture_of(noise.term), atlas_of_lines(lines)});
        }
    if (full)
        cases.push_back({"value smooth, a run of 16384 texels of 0.01 cells",
                         texture_of(kernel_terms()[1].term),
                         atlas_of_lines({{{-80.0, 3.0, 0.1}, {0.01, 0.003, -0.007}, 16384}})});
    return cases;
}

Cases frequencies(bool full) {
    Cases cases;
    for (const NamedTerm& noise : kernel_terms())
        for (int power = 0; power <= 20; power += full ? 1 : 5)
            for (const bool of_solid : {false, true}) {
                NoiseTerm term = noise.term;
                const double frequency = std::ldexp(1.0, power);
                term.octaves = 1, term.frequency = frequency * Vec3d(1.0, -1.0, 0.9);
                const double step = of_solid ? 1.0 / 1024 : 1.0 / 16 / frequency;
                cases.push_back(
                    {fmt::format("{}, frequency 2^{}, texels of {:g}", noise.name, power, step),
                     texture_of(term),
                     random_lines(Vec3d(0.3), step, 48, 8, std::uint32_t(power))});
            }
    return cases;
}

Cases octaves(bool full) {
    Cases cases;
    for (const NamedTerm& noise : kernel_terms())
        for (std::uint32_t count = 1; count <= 24; count += full ? 1 : 23)
            for (const double gain : {0.0, 0.25, 0.5, 1.0, 1.5, 2.0})
                for (const double lacunarity : {0.5, 1.9, 2.0, 3.0}) {
                    NoiseTerm term = noise.term;
                    term.octaves = count, term.gain = gain, term.lacunarity = lacunarity;
                    cases.push_back({fmt::format("{}, {} octaves, gain {}, lacunarity {}",
                                                 noise.name, count, gain, lacunarity),
                                     texture_of(term),
                                     random_lines(Vec3d(0.3), 1e-3, 24, 4, count)});
                }
    return cases;
}

/// Quadrics up to 1e12 with a map that repeats; the noise is a small part of f.
Cases quadrics(bool full) {
    Cases cases;
    for (int power = 0; power <= 12; power += full ? 1 : 4)
        for (std::uint32_t seed = 0; seed < 6; ++seed) {
            Chance chance(seed);
            Texture texture = texture_of(kernel_terms()[seed % 4].term);
            Quadric& q = texture.quadric;
            const double scale = power > 9 ? std::pow(10.0, 0.5 * (power - 9)) : 1.0;
            for (double* c : {&q.a, &q.b, &q.c, &q.d, &q.e, &q.f, &q.g, &q.h, &q.i, &q.j})
                *c = std::pow(10.0, std::min(power, 9)) * chance.signed_unit();
            const Vec3d place = scale * chance.vector();
            const std::uint32_t run = full && seed == 0 ? 3000 : 48;
            cases.push_back({fmt::format("|quadric| about 1e{}, seed {}", power, seed), texture,
                             random_lines(place, scale * 1e-3, run, 8, seed)});
        }
    return cases;
}

/// Noises and sums that are added texel by texel.
Cases other_noises(bool full) {
    Cases cases;
    for (const auto& kind : noise_kinds)
        for (const OctaveShape shape :
             {OctaveShape::plain, OctaveShape::absolute, OctaveShape::ridged})
            for (const double place : {0.3, -1e3, 1e6})
                for (const double step : {1e-4, 0.09}) {
                    NoiseTerm term;
                    term.kind = kind.value, term.shape = shape, term.octaves = full ? 3 : 1;
                    cases.push_back(
                        {fmt::format("{}, shape {}, near {:g}, {:g} cells per texel", kind.name,
                                     int(shape), place, step),
                         texture_of(term),
                         random_lines(Vec3d(place), step, 40, 6, std::uint32_t(cases.size()))});
                }
    return cases;
}

}  // namespace

SolidAtlas atlas_of_lines(const std::vector<TexelLine>& lines) {
    SolidAtlas solid;
    solid.size = std::uint32_t(lines.size());
    for (const TexelLine& line : lines) solid.size = std::max(solid.size, line.count);
    for (std::uint32_t y = 0; y < lines.size(); ++y) {
        solid.row_begin.push_back(solid.spans.size());
        solid.spans.push_back({0, lines[y].count, y});
        solid.maps.push_back({lines[y].start, lines[y].step, Vec3d(0.0), 0, std::int32_t(y)});
    }
    solid.row_begin.resize(solid.size + 1, solid.spans.size());
    return solid;
}

std::vector<StabilityGroup> stability_groups(bool full) {
    return {{"coordinates", coordinates(full)},
            {"beyond 2^31", far_cells(full)},
            {"lattice planes", lattice_planes(full)},
            {"runs", runs(full)},
            {"frequencies", frequencies(full)},
            {"octaves", octaves(full)},
            {"quadrics", quadrics(full)},
            {"other noises", other_noises(full)},
            mesh_group(full)};
}

}  // namespace burl
