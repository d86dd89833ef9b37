#include "procedural/fixed/index.h"

#include <algorithm>
#include <cmath>

namespace burl {

namespace {

/// The size of the quadric from which float64 itself loses units of the index.
constexpr double largest_base = 0x1p16;
/// The error of the index above which too many texels would stay undecided.
constexpr double largest_error = 0x1p-22;

bool has_hash(const Octave& octave) {
    return has_kernel(octave) && octave.noise.kind != NoiseKind::simplex;
}

/// The index in units of 2^-fraction_bits, rounded down, modulo 2^32.
std::uint32_t units_of(double index, int fraction_bits) {
    return std::uint32_t(std::int64_t(std::floor(std::ldexp(index, fraction_bits))));
}

/// A bound of a group's |sum|: value noise is a mean of numbers in [-1, 1], Perlin's of numbers of
/// at most 2.
double largest_sum(const OctaveGroup& group) {
    double weights = 0.0;
    for (const StreamOctave& octave : group.octaves) weights += std::abs(double(octave.weight));
    const double noise = group.kind == NoiseKind::perlin ? 2.0 : 1.0;
    return 1.001 * noise * weights / stream_unit(group.kind);
}

/// A bound of the change of the index by all groups together.
double largest_change(std::span<const OctaveGroup> groups) {
    double change = 0.0;
    for (const OctaveGroup& group : groups)
        change += std::abs(group.scale * stream_unit(group.kind)) * largest_sum(group);
    return change;
}

/// The fixed-point term of a group.
FixedTerm fixed_term(const OctaveGroup& group, int fraction_bits) {
    int exponent = 0;
    std::frexp(largest_sum(group), &exponent);
    FixedTerm term;
    term.whole = float(std::ldexp(1.0, 31 - exponent));
    // A unit of the product's upper half is 2^32 units of the product.
    const double units =
        std::ldexp(group.scale * stream_unit(group.kind) / double(term.whole), fraction_bits + 32);
    std::frexp(units, &exponent);
    term.shift = std::max(0, exponent - 31);
    term.factor = std::int32_t(std::lround(std::ldexp(units, -term.shift)));
    return term;
}

/// A bound of the error of the index in units. Per term: the sum is off by less than one of 2^31,
/// the factor by half of one of 2^30 or more, and the lower half is dropped, 2 units of 2^shift
/// together. The base is rounded down, too; the constant's and float64's own roundings stay below a
/// unit.
double fixed_error(std::span<const FixedTerm> terms) {
    double error = 5.0;
    for (const FixedTerm& term : terms) error += 2.0 * std::ldexp(1.0, term.shift);
    return error;
}

/// Sets the range and the fraction bits of an index that is not repeated, so that indices outside
/// [0, 1] fit; by powers of two, so that amplitudes change it seldom.
void make_room(FixedIndex& field, double change) {
    const double reach = std::exp2(std::ceil(std::log2(std::max(change, 1.0))));
    field.lowest = -reach - 1.0, field.highest = reach + 2.0;
    field.fraction_bits = 30 - int(std::ceil(std::log2(2.0 * reach + 2.0)));
}

}  // namespace

std::optional<FixedIndex> fixed_index(const Texture& texture) {
    const std::vector<Octave> octaves = expand_octaves(texture);
    if (!std::ranges::all_of(octaves, has_hash)) return std::nullopt;
    FixedIndex field;
    field.groups = group_octaves(octaves);
    field.repeats = texture.colors.wrap == Wrap::repeat;
    double constant = 0.0;
    for (const Octave& octave : octaves) constant += octave.offset;
    const double change = largest_change(field.groups) + std::abs(constant);
    if (!(change < 1024.0)) return std::nullopt;
    if (!field.repeats) make_room(field, change);
    field.constant = units_of(constant, field.fraction_bits);
    for (const OctaveGroup& group : field.groups)
        field.terms.push_back(fixed_term(group, field.fraction_bits));
    field.error = fixed_error(field.terms);
    if (std::ldexp(field.error, -field.fraction_bits) > largest_error) return std::nullopt;
    return field;
}

std::uint32_t fixed_tolerance(const FixedIndex& field, int step_bits) {
    return 2 + std::uint32_t(std::ceil(std::ldexp(field.error, step_bits - field.fraction_bits)));
}

std::optional<std::uint32_t> fixed_base(const FixedIndex& field, double q) {
    if (!(std::abs(q) < largest_base)) return std::nullopt;
    const double index = field.repeats ? q : std::clamp(q, field.lowest, field.highest);
    const std::uint32_t base = units_of(index, field.fraction_bits);
    return base == no_base ? base + 1 : base;
}

}  // namespace burl
