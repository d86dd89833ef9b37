// Integers are held in 64 bits; products of two values of the format need at most 62.
#include "procedural/fixed/field.h"

#include <algorithm>
#include <cmath>

namespace burl {

namespace {

using Point3 = std::array<FixedInteger, 3>;

Vec3d as_vector(const Point3& units) {
    return {double(units[0]), double(units[1]), double(units[2])};
}

}  // namespace

bool has_fixed_point(const Texture& texture) {
    const std::vector<Octave> octaves = expand_octaves(texture);
    return std::all_of(octaves.begin(), octaves.end(),
                       [](const Octave& octave) { return has_fixed_point(octave.noise); });
}

FixedField::FixedField(const Texture& texture, const FixedFormat& format)
    : format_(format), quadric_(texture.quadric), octaves_(expand_octaves(texture)) {
    double constant = quadric_.j;
    for (const Octave& octave : octaves_) constant += octave.offset;
    constant_ = stopped(units(constant));
}

double FixedField::units(double x) const {
    return std::ldexp(x, int(format_.fraction_bits));
}

FixedInteger FixedField::stopped(FixedInteger units) const {
    const FixedInteger end = FixedInteger(1) << (format_.integer_bits + format_.fraction_bits - 1);
    return std::clamp(units, -end, end - 1);
}

FixedInteger FixedField::stopped(double units) const {
    // Infinite terms may cancel to NaN.
    if (std::isnan(units)) return 0;
    return stopped(FixedInteger(std::clamp(std::floor(units), -0x1p40, 0x1p40)));
}

/// The quadric without its constant: s . (Q s + 2 (D, G, I)), Q its symmetric 3 x 3 part.
FixedInteger FixedField::quadric(const Point3& s) const {
    const Vec3d linear(units(quadric_.d), units(quadric_.g), units(quadric_.i));
    const Vec3d turned = half_gradient_change(quadric_, as_vector(s)) + 2.0 * linear;
    FixedInteger sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        sum = stopped(sum + (s[axis] * stopped(turned[int(axis)]) >> format_.fraction_bits));
    return sum;
}

FixedInteger FixedField::octave(const Octave& octave, const Point3& s) const {
    const Affine3& map = octave.lattice_from_solid;
    const Vec3d moved = map.linear * as_vector(s);
    Point3 p;
    for (int axis = 0; axis < 3; ++axis)
        p[std::size_t(axis)] = wrapped_units(moved[axis] + units(map.offset[axis]), format_);
    const FixedInteger n = fixed_noise_units(octave.noise, format_, p), size = std::abs(n);
    const FixedInteger below = (FixedInteger(1) << format_.fraction_bits) - size;
    switch (octave.shape) {
        case OctaveShape::plain:
            return stopped(octave.scale * double(n));
        case OctaveShape::absolute:
            return stopped(octave.scale * double(size));
        case OctaveShape::ridged:
            return stopped(octave.scale * double(below * below >> format_.fraction_bits));
    }
    return 0;
}

double FixedField::operator()(const Vec3d& point) const {
    Point3 s;
    for (int axis = 0; axis < 3; ++axis)
        s[std::size_t(axis)] = fixed_coordinate(point[axis], format_);
    FixedInteger f = stopped(quadric(s) + constant_);
    for (const Octave& one : octaves_) f = stopped(f + octave(one, s));
    return std::ldexp(double(f), -int(format_.fraction_bits));
}

FixedSpread spread_over(const FixedField& field, const Vec3d& s, const Footprint& sides) {
    const double f = field(s);
    return {f, field(s + sides.u) - f, field(s + sides.v) - f};
}

}  // namespace burl
