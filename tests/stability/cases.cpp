#include "tests/stability/cases.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "procedural/model/octaves.h"
#include "procedural/noise/names.h"
#include "tests/stability/truth.h"

namespace burl {

namespace {

using enum StabilityChoice;
using Cases = std::vector<StabilityCase>;

/// Returns every `stride`-th element.
template <class T>
std::vector<T> thinned_out(const std::vector<T>& all, std::size_t stride) {
    std::vector<T> some;
    for (std::size_t i = 0; i < all.size(); i += stride) some.push_back(all[i]);
    return some;
}

std::size_t lines_for(StabilityChoice choice) {
    return choice == thinned ? 2 : choice == usual ? 6 : 40;
}

/// Whether a place is too far away for a noise: white noise has lattice points 2^-16 apart, and
/// rounding chooses among them.
bool is_lost(const NamedTerm& noise, double cells) {
    return noise.term.kind == NoiseKind::white && std::abs(cells) > 1e8;
}

/// Returns the stride through the steps, larger for noises evaluated texel by texel, whose texels
/// share no work.
std::size_t step_stride(StabilityChoice choice, const NamedTerm& noise) {
    if (choice == thorough) return 1;
    return choice == thinned || !has_long_form({.kind = noise.term.kind}) ? 4 : 1;
}

Cases coordinates(StabilityChoice choice) {
    const std::vector<double> sizes{0.0,  5e-324, 1e-310, 1e-30, 1e-16, 1e-8,
                                    1e-3, 0.5,    1.0,    1e3,   1e6,   1e9};
    const std::vector<double> steps{1e-9, 1e-7, 1e-5, 1e-3, 1.0 / 64, 0.25, 1.0, 30.0, 1e3};
    Cases cases;
    for (const NamedTerm& noise : terms_for(choice))
        for (const double size : thinned_out(sizes, choice == thinned ? 2 : 1))
            for (const double sign : {1.0, -1.0})
                for (const double step : thinned_out(steps, step_stride(choice, noise))) {
                    if (is_lost(noise, size)) continue;
                    const Vec3d place = sign * size * Vec3d(1.0, -0.7, 0.3);
                    cases.push_back({fmt::format("{} near {:g}, {:g} cells per texel", noise.name,
                                                 sign * size, step),
                                     texture_of(noise.term),
                                     random_lines(place, step, 48, lines_for(choice),
                                                  std::uint32_t(cases.size()))});
                }
    return cases;
}

/// Returns lattice coordinates beyond 2^31, where cells wrap, up to the largest ones accepted.
Cases far_cells(StabilityChoice choice) {
    Cases cases;
    for (const NamedTerm& noise : terms_for(choice))
        for (int power = 31; power <= 42; power += choice == thinned ? 4 : 1)
            for (const double step : {1.0 / 64, 1.0, 1e3}) {
                const double far = std::ldexp(1.0, power);
                if (is_lost(noise, far)) continue;
                cases.push_back(
                    {fmt::format("{} near 2^{}, {:g} cells per texel", noise.name, power, step),
                     texture_of(noise.term),
                     random_lines({far, -far, 0.4 * far}, step, 48, lines_for(choice),
                                  std::uint32_t(power))});
            }
    return cases;
}

/// Returns lines that begin some floats before a lattice plane and cross it float by float, lines
/// in the plane, and lines that meet a plane at every eighth texel.
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

Cases lattice_planes(StabilityChoice choice) {
    Chance chance(3);
    Cases cases;
    for (const NamedTerm& noise : terms_for(choice))
        for (const double plane : {0.0, 1.0, -1.0, 7.0, -4096.0, 0x1p20, -0x1p30, 0x1p31 - 1.0,
                                   0x1p31, -0x1p31, 0x1p32, 0x1p40})
            if (!is_lost(noise, plane))
                cases.push_back({fmt::format("{} across the plane {:g}", noise.name, plane),
                                 texture_of(noise.term), plane_lines(plane, chance)});
    return cases;
}

Cases runs(StabilityChoice choice) {
    std::vector<std::uint32_t> lengths{1,  2,  3,   7,    8,    9,    15,  16,
                                       17, 63, 255, 1000, 1023, 1024, 1025};
    if (choice == thorough) lengths.insert(lengths.end(), {2049, 4096});
    const std::vector<double> steps{1e-9, 1e-4, 1.0 / 256, 1.0 / 16, 0.7};
    Cases cases;
    for (const NamedTerm& noise : terms_for(choice))
        for (const double step : thinned_out(steps, choice == thinned ? 3 : 1)) {
            Chance chance(std::uint32_t(cases.size()));
            std::vector<TexelLine> lines;
            for (const std::uint32_t length : lengths)
                lines.push_back({10.0 * chance.vector(), step * chance.vector(), length});
            cases.push_back({fmt::format("{}, runs of 1 to {} texels of {:g} cells", noise.name,
                                         lengths.back(), step),
                             texture_of(noise.term), atlas_of_lines(lines)});
        }
    return cases;
}

/// Returns the longest runs; images are square, so these are large.
Cases longest_runs(StabilityChoice choice) {
    Cases cases;
    if (choice == thinned) return cases;
    for (const NamedTerm& noise : thinned_out(named_terms(), choice == usual ? 3 : 1))
        for (const std::uint32_t length : {4096u, 16384u})
            if (length < 16384 || choice == thorough || cases.size() < 2)
                cases.push_back(
                    {fmt::format("{}, a run of {} texels of 0.01 cells", noise.name, length),
                     texture_of(noise.term),
                     atlas_of_lines({{{-80.0, 3.0, 0.1}, {0.01, 0.003, -0.007}, length}})});
    return cases;
}

Cases frequencies(StabilityChoice choice) {
    Cases cases;
    for (const NamedTerm& noise : terms_for(choice))
        for (int power = 0; power <= 20; power += choice == thinned ? 5 : 1)
            for (const bool of_solid : {false, true}) {
                NoiseTerm term = noise.term;
                const double frequency = std::ldexp(1.0, power);
                term.octaves = 1, term.frequency = frequency * Vec3d(1.0, -1.0, 0.9);
                const double step = of_solid ? 1.0 / 1024 : 1.0 / 16 / frequency;
                cases.push_back(
                    {fmt::format("{}, frequency 2^{}, texels of {:g}", noise.name, power, step),
                     texture_of(term),
                     random_lines(Vec3d(0.3), step, 48, lines_for(choice), std::uint32_t(power))});
            }
    return cases;
}

Cases octaves(StabilityChoice choice) {
    Cases cases;
    for (const NamedTerm& noise : terms_for(choice))
        for (std::uint32_t count = 1; count <= 24; count += choice == thinned ? 23 : 1)
            for (const double gain : {0.0, 0.25, 0.5, 1.0, 1.5, 2.0})
                for (const double lacunarity : {0.5, 1.9, 2.0, 3.0}) {
                    NoiseTerm term = noise.term;
                    term.octaves = count, term.gain = gain, term.lacunarity = lacunarity;
                    if (is_lost(noise, std::pow(lacunarity, count - 1))) continue;
                    if (choice == usual && !has_long_form({.kind = term.kind}) && count % 12 != 0)
                        continue;
                    if (choice == usual && count > 4 && count % 4 != 0) continue;
                    cases.push_back(
                        {fmt::format("{}, {} octaves, gain {}, lacunarity {}", noise.name, count,
                                     gain, lacunarity),
                         texture_of(term),
                         random_lines(Vec3d(0.3), 1e-3, 24, choice == thorough ? 16 : 3, count)});
                }
    return cases;
}

/// Returns quadrics up to 1e12 with a map that repeats; the noise is a small part of f.
Cases quadrics(StabilityChoice choice) {
    Cases cases;
    const std::vector<NamedTerm> terms = named_terms();
    for (int power = 0; power <= 12; power += choice == thinned ? 4 : 1)
        for (std::uint32_t seed = 0; seed < (choice == thorough ? 40u
                                             : choice == usual  ? 12u
                                                                : 4u);
             ++seed) {
            Chance chance(seed);
            const NamedTerm& noise = terms[seed % terms.size()];
            Texture texture = texture_of(noise.term);
            Quadric& q = texture.quadric;
            const double scale = power > 9 ? std::pow(10.0, 0.5 * (power - 9)) : 1.0;
            for (double* c : {&q.a, &q.b, &q.c, &q.d, &q.e, &q.f, &q.g, &q.h, &q.i, &q.j})
                *c = std::pow(10.0, std::min(power, 9)) * chance.signed_unit();
            const Vec3d place = scale * chance.vector();
            const std::uint32_t run = choice != thinned && seed == 0 ? 3000 : 48;
            cases.push_back(
                {fmt::format("|quadric| about 1e{}, seed {}, with {}", power, seed, noise.name),
                 texture, random_lines(place, scale * 1e-3, run, 8, seed)});
        }
    return cases;
}

/// Returns sums of |n| and (1 - |n|)^2, periodic noise and noise in time, all added texel by texel.
Cases other_sums(StabilityChoice choice) {
    Cases cases;
    for (const NamedTerm& noise : terms_for(choice))
        for (const OctaveShape shape :
             {OctaveShape::plain, OctaveShape::absolute, OctaveShape::ridged})
            for (const int extra : {0, 1, 2})
                for (const double place : {0.3, -1e3, 1e6})
                    for (const double step : {1e-4, 0.09}) {
                        if (choice == thinned && (step == 1e-4) != (extra == 0)) continue;
                        NoiseTerm term = noise.term;
                        term.shape = shape, term.octaves = choice == thinned ? 1 : term.octaves;
                        if (extra == 1) term.period = {3, 300, 0};
                        if (extra == 2) term.time = 0.3;
                        if (extra == 2 && !has_dimensions(term.kind, 4)) continue;
                        if (extra == 0 && shape == OctaveShape::plain) continue;
                        cases.push_back(
                            {fmt::format("{}, {}{}, near {:g}, {:g} cells per texel", noise.name,
                                         sum_names[std::size_t(shape)].name,
                                         std::array{"", ", periods 3 and 300", ", time 0.3"}[extra],
                                         place, step),
                             texture_of(term),
                             random_lines(Vec3d(place), step, 40, 6, std::uint32_t(cases.size()))});
                    }
    return cases;
}

}  // namespace

std::vector<NamedTerm> named_terms() {
    std::vector<NamedTerm> terms;
    const auto add = [&](std::string name, NoiseKind kind) -> NoiseTerm& {
        NoiseTerm term;
        term.kind = kind, term.seed = std::uint32_t(terms.size());
        term.octaves = has_jumps({.kind = kind}) ? 1 : 4;
        terms.push_back({std::move(name), term});
        return terms.back().term;
    };
    for (const auto& fade : fade_names)
        add(fmt::format("value {}", fade.name), NoiseKind::value).fade = fade.value;
    for (const auto& kind : noise_kinds) {
        if (kind.value == NoiseKind::value || kind.value == NoiseKind::worley) continue;
        add(std::string(kind.name), kind.value);
    }
    NoiseTerm& continuous = add("simplex of radius2 0.5", NoiseKind::simplex);
    continuous.radius2 = 0.5, continuous.octaves = 4;
    for (const auto& feature : feature_names)
        add(fmt::format("worley {}", feature.name), NoiseKind::worley).feature = feature.value;
    return terms;
}

std::vector<NamedTerm> terms_for(StabilityChoice choice) {
    std::vector<NamedTerm> terms = named_terms();
    if (choice == thinned)  // keeps noises that have kernels
        std::erase_if(terms, [](const NamedTerm& one) {
            return !has_long_form({.kind = one.term.kind}) || one.name == "value quintic" ||
                   one.name == "simplex";
        });
    return terms;
}

Texture texture_of(const NoiseTerm& term) {
    Texture texture;
    texture.noise = {term};
    texture.colors.stops = {{0.0, {20, 20, 20}}, {0.5, {230, 200, 120}}, {1.0, {20, 20, 20}}};
    return texture;
}

SolidAtlas random_lines(const Vec3d& place, double step, std::uint32_t count, std::size_t lines,
                        std::uint32_t seed) {
    Chance chance(seed);
    std::vector<TexelLine> result;
    for (std::size_t i = 0; i < lines; ++i)
        result.push_back(
            {place + (i % 2 == 0 ? chance.vector() : Vec3d(0.0)), step * chance.vector(), count});
    return atlas_of_lines(result);
}

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

std::vector<StabilityGroup> stability_groups(StabilityChoice choice) {
    return {{"coordinates", coordinates(choice)},
            {"beyond 2^31", far_cells(choice)},
            {"lattice planes", lattice_planes(choice)},
            {"runs", runs(choice)},
            {"longest runs", longest_runs(choice)},
            {"frequencies", frequencies(choice)},
            {"octaves", octaves(choice)},
            {"quadrics", quadrics(choice)},
            {"other sums", other_sums(choice)},
            unit_group(choice),
            mesh_group(choice)};
}

}  // namespace burl
