#include "procedural/cache/edit_tracker.h"

namespace burl {

FieldKey::FieldKey(const Texture& texture, const Filter& filter)
    : quadric(texture.quadric),
      noise(texture.noise),
      kind(filter.kind),
      band_limit(filter.band_limit) {
    if (has_slopes() && kind != FilterKind::trapezoid2) kind = FilterKind::exact;
}

void EditTracker::record(const std::vector<NoiseKey>& octaves, const FieldKey& field) {
    octaves_.resize(octaves.size());
    for (std::size_t k = 0; k < octaves.size(); ++k)
        octaves_[k].note(moved_ || (k < last_octaves_.size() && last_octaves_[k] != octaves[k]));
    quadric_.note(moved_ || (last_field_ && last_field_->quadric != field.quadric));
    std::vector<bool> causes;
    if (moved_ || (last_field_ && *last_field_ != field)) {
        causes.push_back(quadric_.now);
        for (const Change& octave : octaves_) causes.push_back(octave.now);
    }
    field_dragged_ = !causes.empty() && causes == causes_;
    causes_ = std::move(causes);
    moved_ = false;
    last_octaves_ = octaves;
    last_field_ = field;
}

}  // namespace burl
