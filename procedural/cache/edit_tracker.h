#pragma once
// Which parameters of a texture keep changing, as while somebody drags a slider: a cache of what
// depends on them would be filled in vain.
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "procedural/batch/filter.h"
#include "procedural/field/kept_start.h"
#include "procedural/model/texture.h"

namespace burl {

/// Cache key of f and its slopes besides the atlas and its map to the texture's space.
struct FieldKey {
    FieldKey(const Texture& texture, const Filter& filter);
    /// Whether the filter takes the derivatives of f.
    bool has_slopes() const { return kind != FilterKind::none && kind != FilterKind::supersample; }
    bool operator==(const FieldKey&) const = default;

    Quadric quadric;
    std::vector<NoiseTerm> noise;
    FilterKind kind;  ///< all filters that take the same slopes have one kind
    bool band_limit;
};

/// The changes between the fields of one texture after another. A parameter is dragged while it
/// changes in two fields running.
class EditTracker {
  public:
    /// Records the next field; octave k is compared with octave k of the field before.
    void record(const std::vector<NoiseKey>& octaves, const FieldKey& field);
    /// Records a texture that has the field of the one before.
    void record_same_field() { causes_.clear(); }
    /// Lets the next field differ from the one before in everything, since the map does.
    void record_map() { moved_ = true; }
    /// Compares no octave of the next field.
    void forget_octaves() { last_octaves_.clear(); }

    /// Whether octave k is dragged.
    bool octave_dragged(std::size_t k) const { return octaves_[k].again; }
    bool quadric_dragged() const { return quadric_.again; }
    /// Whether f changed in two textures running, and because of the same parameters.
    bool field_dragged() const { return field_dragged_; }

  private:
    /// Whether a parameter changed in this field (`now`), and in the one before as well (`again`).
    struct Change {
        bool now = false, again = false;
        void note(bool changed) { again = std::exchange(now, changed) && changed; }
    };

    bool moved_ = false;
    std::vector<NoiseKey> last_octaves_;
    std::optional<FieldKey> last_field_;
    std::vector<Change> octaves_;
    Change quadric_;
    /// Flags of the last change of f: the quadric changed, then for each octave whether it changed;
    /// empty: f did not change.
    std::vector<bool> causes_;
    bool field_dragged_ = false;
};

}  // namespace burl
