#include "procedural/cache/memory.h"

#include <algorithm>
#include <functional>

namespace burl {

bool CacheMemory::allot_field(bool slopes) {
    const std::size_t wanted = sizeof(double) + (slopes ? 2 * sizeof(float) : 0);
    const bool fits = bytes_per_texel() >= wanted;
    if (!slopes || !fits) slopes_u = {}, slopes_v = {};
    if (!fits) {
        field.free();
        return false;
    }
    if (slopes && !slopes_v.data()) {  // the one that is allotted last
        slopes_u = CacheArray<float>(layout.size());
        slopes_v = CacheArray<float>(layout.size());
    }
    field.allot(layout.size());
    return true;
}

void CacheMemory::allot_octaves(const std::vector<NoiseKey>& keys, const EditTracker& history) {
    using Octaves = decltype(octaves);
    const auto has_array = [](const auto& octave) { return octave.data() != nullptr; };
    std::size_t rest = allot_field(false) ? bytes_per_texel() - sizeof(double) : 0;
    Octaves before = std::exchange(octaves, Octaves(keys.size()));
    for (std::size_t k = 0; k < keys.size() && rest >= sizeof(float); ++k) {
        const auto same = std::ranges::find(before, keys[k], &Octaves::value_type::key);
        if (same == before.end()) continue;
        if (has_array(*same)) {
            octaves[k] = std::move(*same);
            rest -= sizeof(float);
        }
        before.erase(same);
    }
    std::erase_if(before, std::not_fn(has_array));
    for (std::size_t k = 0; k < keys.size() && rest >= sizeof(float); ++k) {
        if (has_array(octaves[k]) || history.octave_dragged(k)) continue;
        rest -= sizeof(float);
        if (!before.empty()) {
            octaves[k] = std::move(before.back());
            octaves[k].invalidate();
            before.pop_back();
        }
        octaves[k].allot(layout.size());
    }
    before.clear();
    if (rest < sizeof(double)) {
        quadric.free();
    } else {
        quadric.allot(layout.size());
        rest -= sizeof(double);
    }
    const std::size_t of_lines = lines.bytes_wanted();
    lines_fit_ = layout.size() > 0 && rest > of_lines / layout.size();
    if (lines_fit_)
        rest -= of_lines / layout.size() + 1;
    else
        lines.free();
    if (rest < sizeof(std::int32_t)) entries.free();
}

void CacheMemory::allot_lines() {
    if (lines_fit_) lines.allot();
}

bool CacheMemory::allot_entries() {
    if (entries.data()) return true;
    if (bytes() + layout.size() * sizeof(std::int32_t) > budget_) return false;
    entries.allot(layout.size());
    return true;
}

void CacheMemory::free_octaves() {
    octaves.clear();
    quadric.free();
    lines.free();
    entries.free();
}

void CacheMemory::invalidate() {
    field.invalidate();
    for (auto& octave : octaves) octave.invalidate();
    quadric.invalidate();
    lines.invalidate();
    entries.invalidate();
}

std::size_t CacheMemory::bytes() const {
    std::size_t per_texel =
        field.bytes_per_texel() + quadric.bytes_per_texel() + entries.bytes_per_texel();
    if (slopes_u.data()) per_texel += 2 * sizeof(float);
    for (const auto& octave : octaves) per_texel += octave.bytes_per_texel();
    return layout.size() * per_texel + lines.bytes();
}

}  // namespace burl
