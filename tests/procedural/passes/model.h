#pragma once
// Evaluation of a multipass plan on the host, texel by texel and pass by pass, rounding wherever an
// image stores: the reference of OpenGL's images (equal bits for float32 where OpenGL's arithmetic
// is IEEE 754's, one unit of the last place otherwise).
#include <map>

#include "procedural/field/lattice_map.h"
#include "procedural/passes/plan.h"
#include "tests/procedural/passes/half_float.h"

namespace burl {

/// The numbers of a texel. With fixed8 they are whole numbers 0..255 and include integer images.
using PassTexel = std::array<float, 3>;
using PassIntegers = std::array<std::uint32_t, 3>;

class MultipassModel {
  public:
    /// A model of a plan for lattice maps, one per stream and at least one, all of one size; the
    /// quadric comes from the first. Plan and maps must outlive the model.
    MultipassModel(const MultipassPlan& plan, std::span<const LatticeMap> maps,
                   HalfRounding rounding = HalfRounding::nearest_even);

    /// Runs passes in order; images must have been written before a pass reads them.
    void run(std::span<const Pass> passes);
    void run() { run(plan_.passes); }

    const std::vector<PassTexel>& image(PassImage image) const { return images_.at(image); }
    const std::vector<PassIntegers>& integers(PassImage image) const { return integers_.at(image); }

  private:
    void run(const Pass& pass);
    void run_integers(const Pass& pass);
    void run_numbers(const Pass& pass);
    template <class Texel>
    void copy(const Pass& pass, const std::vector<Texel>& from, std::vector<Texel>& to) const;

    std::uint64_t coordinate(const Pass& pass, std::size_t texel, unsigned axis) const;
    PassTexel evaluate(const Pass& pass, std::size_t texel) const;
    float solid_code(const Pass& pass, std::size_t texel, unsigned axis) const;
    float random_number(const Pass& pass, std::size_t texel) const;
    float axis_number(const Pass& pass, std::size_t texel) const;
    float value_number(const Pass& pass, float x) const;
    float field_index(const Pass& pass, std::size_t texel) const;
    float product(float a, float b) const;
    float stored(float x) const;

    const MultipassPlan& plan_;
    std::span<const LatticeMap> maps_;
    HalfRounding rounding_;
    bool fixed_;
    std::size_t count_;
    std::map<PassImage, std::vector<PassTexel>> images_;
    std::map<PassImage, std::vector<PassIntegers>> integers_;
};

/// A plane of lattice coordinates as a lattice map with quadric 0: texel (x, y) shows
/// lattice_from_texel(x + 1/2, y + 1/2, 0). The papers' figures are such slices.
LatticeMap lattice_slice(std::size_t width, std::size_t height, const Affine3& lattice_from_texel);

}  // namespace burl
