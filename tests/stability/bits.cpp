// The checks of the stability suite that compare bits.
#include <algorithm>
#include <bit>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "procedural/fill/synthesize.h"
#include "procedural/model/octaves.h"
#include "procedural/numbers/simd_target.h"
#include "tests/stability/checks.h"
#include "tests/stability/truth.h"

namespace burl {

namespace {

/// Returns a 64-bit hash of the numbers' bits; different bits collide with a chance of 2^-64.
template <class Bytes>
std::uint64_t hash_of(const Bytes& values) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const auto value : values) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(double(value))) * 0x100000001b3;
        hash ^= hash >> 29;
    }
    return hash;
}

std::uint64_t color_hash(const StabilityCase& one, FilterKind kind) {
    const Image<RgbF> image =
        synthesize_model<RgbF>(one.solid, one.texture, one.map, 1, {kind, 16, false});
    std::vector<float> channels;
    for (const RgbF& c : image.pixels()) channels.insert(channels.end(), {c.r, c.g, c.b});
    return hash_of(channels);
}

struct Hashed {
    std::string what;
    std::size_t texels;
    std::uint64_t bits;
};

/// Returns hashes of everything that must not depend on the instruction set.
std::vector<Hashed> hashes_of(const StabilityCase& one, bool filters) {
    std::vector<Hashed> result;
    for (const StabilityWay& way : stability_ways()) {
        if (way.arithmetic != "float32") continue;
        const std::vector<double> texels = fill_texels(one, way, 1);
        result.push_back({way.name, texels.size(), hash_of(texels)});
    }
    using enum FilterKind;
    if (filters)
        for (const FilterKind kind : {none, exact, trapezoid, trapezoid2})
            result.push_back({fmt::format("filter {}", int(kind)), result.front().texels,
                              color_hash(one, kind)});
    return result;
}

std::vector<std::vector<Hashed>> all_hashes(const std::vector<const StabilityCase*>& cases,
                                            std::size_t first_filter) {
    std::vector<std::vector<Hashed>> hashes(cases.size());
    tbb::parallel_for(std::size_t(0), cases.size(),
                      [&](std::size_t i) { hashes[i] = hashes_of(*cases[i], i >= first_filter); });
    return hashes;
}

/// Returns the step from one checked case to the next, larger for noises without vectorised code.
std::size_t stride(const StabilityCase& one, StabilityChoice choice) {
    if (choice == StabilityChoice::thorough) return 1;
    bool vectorised = false;
    for (const Octave& octave : expand_octaves(one.texture))
        vectorised = vectorised || has_long_form(octave.noise);
    if (choice == StabilityChoice::thinned) return vectorised ? 19 : 101;
    return vectorised ? 3 : 31;
}

/// Compares the two kernels that promise identical bits.
void compare_kernels(const std::string& input, const std::vector<Hashed>& hashes,
                     StabilityRow& row) {
    const auto hash = [&](const char* name) {
        return std::ranges::find(hashes, std::string("--kernel ") + name, &Hashed::what)->bits;
    };
    row.count(hash("direct") != hash("share"),
              [&] { return fmt::format("{}: --kernel direct and share differ", input); });
}

}  // namespace

StabilityRow check_instruction_sets(const std::vector<StabilityGroup>& groups,
                                    StabilityChoice choice) {
    StabilityRow row;
    row.group = "kernels, instruction sets";
    const StabilityGroup filters = filter_group(choice);
    std::vector<const StabilityCase*> cases;
    const auto add = [&](const StabilityGroup& group) {
        for (std::size_t i = 0; i < group.cases.size(); ++i)
            if (group.cases[i].solid.size <= 1100 && i % stride(group.cases[i], choice) == 0)
                cases.push_back(&group.cases[i]);
    };
    for (const StabilityGroup& group : groups) add(group);
    const std::size_t first_filter = cases.size();
    add(filters);
    row.cases = cases.size();
    const std::vector<std::vector<Hashed>> best = all_hashes(cases, first_filter);
    for (std::size_t i = 0; i < cases.size(); ++i) compare_kernels(cases[i]->input, best[i], row);
    for (const std::string& target : simd_targets()) {
        const OnlySimdTarget only(target);
        const std::vector<std::vector<Hashed>> here = all_hashes(cases, first_filter);
        for (std::size_t i = 0; i < cases.size(); ++i)
            for (std::size_t k = 0; k < here[i].size(); ++k)
                row.count(here[i][k].bits != best[i][k].bits, [&] {
                    return fmt::format("{}, {}, {} against {}", cases[i]->input, here[i][k].what,
                                       target, simd_targets().front());
                });
    }
    return row;
}

}  // namespace burl
