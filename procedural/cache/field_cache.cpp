#include "procedural/cache/field_cache.h"

#include <algorithm>

namespace burl {

void FieldCache::invalidate() {
    history_.record_map();
    start_.forget();
    memory_.invalidate();
}

FieldUse FieldCache::begin(const FieldKey& key, const FieldSampler& sampler) {
    memory_.field.invalidate();
    memory_.entries.invalidate();
    keys_ = sampler.noise_keys();
    history_.record(keys_, key);
    memory_.allot_octaves(keys_, history_);

    double* const f = memory_.field.data();
    FieldUse use;
    use.field = history_.field_dragged() ? nullptr : f;
    FieldStart& start = use.arrays.start = start_.begin(sampler.sum(), use.field ? nullptr : f);
    octaves_.clear();
    for (auto& octave : memory_.octaves) {
        const bool valid = octave.key().has_value();
        const bool in_prefix = start.known && octaves_.size() < start.octaves;
        if (in_prefix && !valid) octave.free();
        octaves_.push_back({octave.data(), valid || in_prefix});
    }
    use.arrays.octaves = octaves_;

    use.arrays.quadric_known = memory_.quadric.holds(key.quadric);
    if (!use.arrays.quadric_known) memory_.quadric.invalidate();
    const bool stores_quadric = !history_.quadric_dragged() && !start.known;
    if (use.arrays.quadric_known || stores_quadric) use.arrays.quadric = memory_.quadric.data();

    use.all_known = (use.arrays.quadric_known || start.known) &&
                    std::ranges::all_of(octaves_, &KeptNoise::known);
    if (!use.all_known && !sampler.needs_pieces(use.arrays, 0.0)) memory_.allot_lines();
    if (memory_.lines.allotted()) use.lines = &memory_.lines;
    return use;
}

void FieldCache::end(const FieldKey& key, const FieldUse& use, bool complete) {
    start_.end(use.arrays.start.known || complete);
    if (!complete) {
        std::erase_if(memory_.octaves, [](const auto& octave) { return !octave.key(); });
        return;
    }
    for (std::size_t k = 0; k < keys_.size(); ++k) memory_.octaves[k].set_key(keys_[k]);
    if (use.arrays.quadric) memory_.quadric.set_key(key.quadric);
    if (use.field) memory_.field.set_key(key);
}

bool FieldCache::begin_filtered(const FieldKey& key) {
    history_.forget_octaves();
    start_.forget();
    memory_.free_octaves();
    memory_.field.invalidate();
    return memory_.allot_field(key.has_slopes());
}

void FieldCache::end_filtered(const FieldKey& key, bool complete) {
    if (complete) memory_.field.set_key(key);
}

EntriesUse FieldCache::begin_entries(Wrap wrap) {
    if (!memory_.allot_entries()) return {};
    const bool known = memory_.entries.holds(wrap);
    if (!known) memory_.entries.invalidate();
    return {memory_.entries.data(), known};
}

void FieldCache::end_entries(Wrap wrap, bool complete) {
    if (complete) memory_.entries.set_key(wrap);
}

}  // namespace burl
