// The cache's memory: arrays are allotted within the budget in order of priority, and reused from
// one texture to the next.
#include <algorithm>
#include <utility>

#include "procedural/kept/kept.h"

namespace burl {

/// Invalidates the cache, whose memory stays for the next texture.
void KeptSynthesis::forget() {
    moved_ = true;
    known_field_.reset();
    start_.forget();
    lines_.forget();
    known_quadric_.reset();
    for (KeptOctave& octave : octaves_) octave.key.doublings = -1;  // no octave has this key
}

void KeptSynthesis::forget_octaves() {
    octaves_.clear();
    last_keys_.clear();
    start_.forget();
    lines_.drop();
    entries_ = {};
    quadric_ = {};
    known_quadric_.reset();
}

std::size_t KeptSynthesis::bytes() const {
    const auto kept = [](const auto& array) { return array.data() ? sizeof(*array.data()) : 0; };
    std::size_t bytes =
        kept(field_) + kept(quadric_) + kept(slopes_u_) + kept(slopes_v_) + kept(entries_);
    for (const KeptOctave& octave : octaves_) bytes += kept(octave.noise);
    return rows_.size() * bytes + lines_.bytes();
}

bool KeptSynthesis::keep_field(bool slopes) {
    const std::size_t wanted = sizeof(double) + (slopes ? 2 * sizeof(float) : 0);
    const bool fits = bytes_per_texel() >= wanted;
    if (!slopes || !fits) slopes_u_ = {}, slopes_v_ = {};
    if (!fits) field_ = {};
    if (fits && slopes && !slopes_u_.data()) {
        slopes_u_ = KeptArray<float>(rows_.size());
        slopes_v_ = KeptArray<float>(rows_.size());
    }
    if (fits && !field_.data()) field_ = KeptArray<double>(rows_.size());
    return fits;
}

/// Allots arrays for the noise of `keys`: an octave that is cached keeps its array, others take
/// over freed arrays. The member octaves_ is left empty, so that an exception leaves nothing that
/// was not evaluated.
std::vector<KeptSynthesis::KeptOctave> KeptSynthesis::keep(const std::vector<NoiseKey>& keys) {
    const std::size_t most = bytes_per_texel();
    std::size_t rest = keep_field(false) ? most - sizeof(double) : 0;
    std::vector<KeptOctave> before = std::exchange(octaves_, {}), octaves(keys.size());
    for (std::size_t k = 0; k < keys.size(); ++k) {
        octaves[k].key = keys[k];
        const auto same = std::ranges::find(before, keys[k], &KeptOctave::key);
        if (same == before.end() || rest < sizeof(float)) continue;
        octaves[k].noise = std::move(same->noise);
        octaves[k].known = octaves[k].noise.data() != nullptr;
        before.erase(same);
        rest -= octaves[k].known ? sizeof(float) : 0;
    }
    std::erase_if(before, [](const KeptOctave& octave) { return !octave.noise.data(); });
    for (std::size_t k = 0; k < keys.size(); ++k) {
        if (octaves[k].known || octave_changes_[k].again || rest < sizeof(float)) continue;
        rest -= sizeof(float);
        if (before.empty()) {
            octaves[k].noise = KeptArray<float>(rows_.size());
        } else {
            octaves[k].noise = std::move(before.back().noise);
            before.pop_back();
        }
    }
    before.clear();
    if (rest < sizeof(double)) {
        quadric_ = {};
        known_quadric_.reset();
    } else {
        rest -= sizeof(double);
        if (!quadric_.data()) {
            quadric_ = KeptArray<double>(rows_.size());
            known_quadric_.reset();
        }
    }
    const std::size_t lines = lines_.bytes_wanted();
    lines_fit_ = rows_.size() > 0 && rest > lines / rows_.size();
    if (lines_fit_)
        rest -= lines / rows_.size() + 1;
    else
        lines_.drop();
    if (rest < sizeof(std::int32_t)) entries_ = {};
    return octaves;
}

/// Allots the colour table's entries; false if the budget has no room for them.
bool KeptSynthesis::keep_entries() {
    if (entries_.data()) return true;
    if (bytes() + rows_.size() * sizeof(std::int32_t) > budget_) return false;
    entries_ = KeptArray<std::int32_t>(rows_.size());
    known_entries_.reset();
    return true;
}

}  // namespace burl
