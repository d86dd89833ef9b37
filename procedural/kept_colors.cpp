#include "procedural/kept_colors.h"

#include <bit>
#include <limits>

#include "procedural/color_entries.h"

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kept_colors.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/set_bits-inl.h"
#include "procedural/vector_types-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// As LookUpCodes, of places.
HWY_ATTR std::size_t LookUpPlaces(const ColorCode* table, const std::int32_t* places,
                                  std::size_t count, ColorCode* codes, std::uint32_t* later) {
    const Bits d;
    const auto* words = reinterpret_cast<const std::uint32_t*>(table);
    auto* out = reinterpret_cast<std::uint32_t*>(codes);
    const auto flag = hn::Set(d, std::bit_cast<std::uint32_t>(ColorCode{{0, 0, 0}, true}));
    std::size_t found = 0;
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        const auto entries = hn::ShiftRight<16>(hn::Load(Ints(), places + j));
        const auto code = hn::GatherIndex(d, words, entries);
        hn::Store(code, d, out + j);
        const auto several = hn::Eq(hn::And(code, flag), hn::Zero(d));
        if (hn::AllFalse(d, several)) continue;
        found += SetPositions(MaskBytes(several), std::uint32_t(j), later + found);
    }
    return found_below(count, later, found);
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

namespace {

constexpr std::uint32_t places_per_entry = std::uint32_t(1) << 16, counted_steps = 4;

}  // namespace

KeptColors::KeptColors(const ColorMap& map)
    : table_(map), entries_(places / places_per_entry + 1), first_step_(entries_.size()) {
    const auto steps = table_.steps();
    constexpr std::int32_t beyond = std::numeric_limits<std::int32_t>::max();
    for (const auto& [index, color] : steps) {
        step_places_.push_back(index <= 1.0 ? std::int32_t(index * places) : beyond);
        step_codes_.push_back({color, true});
    }
    step_places_.resize(steps.size() + counted_steps, beyond);
    fill_color_entries(steps, entries_, first_step_);
}

/// Places of steps below that of f are steps below f; only where they are equal f decides, and only
/// then it is read.
ColorCode KeptColors::searched(std::int32_t place, const double& f) const {
    const std::uint32_t first = first_step_[std::uint32_t(place) / places_per_entry];
    // Few entries have more than these, which no branch has to tell apart: the three channels of
    // greys change together.
    std::uint32_t step = first;
    for (std::uint32_t k = 1; k <= counted_steps; ++k) step += step_places_[first + k] < place;
    while (step_places_[step + 1] < place) ++step;
    if (step_places_[step + 1] == place) {
        const double t = map_index(table_.wrap(), f);
        while (table_.steps()[step + 1].index <= t) ++step;
    }
    return step_codes_[step];
}

HWY_EXPORT(LookUpPlaces);

void KeptColors::look_up(const std::int32_t* at, const double* f, std::size_t count,
                         ColorCode* codes, std::uint32_t* later) const {
    const std::size_t searches =
        HWY_DYNAMIC_DISPATCH(LookUpPlaces)(entries_.data(), at, count, codes, later);
    for (std::size_t i = 0; i < searches; ++i)
        codes[later[i]] = searched(at[later[i]], f[later[i]]);
}

}  // namespace burl
#endif
