#include "tests/procedural/passes/model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "procedural/color/table.h"
#include "procedural/numbers/lattice_hash.h"

namespace burl {

namespace {

/// x, or 0 where it is subnormal, as in shaders.
float flushed(float x) {
    return std::abs(x) < std::numeric_limits<float>::min() ? 0.0f : x;
}

/// The whole number nearest to x, halves rounded up.
float whole(float x) {
    return std::floor(x + 0.5f);
}

/// x in 32.32 fixed point.
std::uint64_t fixed_point(double x) {
    const double cell = std::floor(x);
    return (std::uint64_t(std::int64_t(cell)) << 32) + std::uint64_t((x - cell) * 0x1p32);
}

}  // namespace

MultipassModel::MultipassModel(const MultipassPlan& plan, std::span<const LatticeMap> maps,
                               HalfRounding rounding)
    : plan_(plan),
      maps_(maps),
      rounding_(rounding),
      fixed_(plan.options.precision == PassPrecision::fixed8),
      count_(maps[0].cells.pixels().size()) {}

void MultipassModel::run(std::span<const Pass> passes) {
    for (const Pass& pass : passes) run(pass);
}

void MultipassModel::run(const Pass& pass) {
    if (holds_integers(pass.target, plan_.options.precision))
        run_integers(pass);
    else
        run_numbers(pass);
}

template <class Texel>
void MultipassModel::copy(const Pass& pass, const std::vector<Texel>& from,
                          std::vector<Texel>& to) const {
    to.resize(count_);
    for (std::size_t i = 0; i < count_; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (pass.mask[axis]) to[i][axis] = from[i][axis];
}

void MultipassModel::run_integers(const Pass& pass) {
    if (pass.kind == PassKind::copy)
        return copy(pass, integers_.at(pass.first), integers_[pass.target]);
    std::vector<PassIntegers> result(count_);
    for (std::size_t i = 0; i < count_; ++i)
        for (unsigned axis = 0; axis < 3; ++axis)
            result[i][axis] = pass.kind == PassKind::cells
                                  ? std::uint32_t(coordinate(pass, i, axis) >> 32)
                                  : integers_.at(pass.first)[i][axis] + 1;
    integers_[pass.target] = std::move(result);
}

void MultipassModel::run_numbers(const Pass& pass) {
    if (pass.kind == PassKind::copy)
        return copy(pass, images_.at(pass.first), images_[pass.target]);
    std::vector<PassTexel> result(count_);
    for (std::size_t i = 0; i < count_; ++i) {
        result[i] = evaluate(pass, i);
        for (float& x : result[i]) x = stored(x);
    }
    images_[pass.target] = std::move(result);
}

/// The lattice coordinate of a texel after the pass's doublings, in 32.32 fixed point.
std::uint64_t MultipassModel::coordinate(const Pass& pass, std::size_t texel, unsigned axis) const {
    const LatticeMap& map = maps_[pass.stream];
    const int at = int(axis);
    return (std::uint64_t(map.cells.pixels()[texel][at]) << 32 | map.places.pixels()[texel][at])
           << pass.doublings;
}

PassTexel MultipassModel::evaluate(const Pass& pass, std::size_t i) const {
    const auto each = [](const auto& function) {
        return PassTexel{function(0u), function(1u), function(2u)};
    };
    const auto same = [](float x) { return PassTexel{x, x, x}; };
    const auto find = [&](PassImage image) {
        const auto found = images_.find(image);
        return found == images_.end() ? PassTexel{} : found->second[i];
    };
    const PassTexel x = find(pass.first), y = find(pass.second);
    switch (pass.kind) {
        case PassKind::places:
            return each([&](unsigned axis) {
                return float(std::uint32_t(coordinate(pass, i, axis))) * 0x1p-32f;
            });
        case PassKind::solid_map:
            return each([&](unsigned axis) { return solid_code(pass, i, axis); });
        case PassKind::transfer:
            return each([&](unsigned axis) {
                const float z = pass.scale * x[axis] + pass.bias;
                return pass.wraps && z >= 256.0f ? z - 256.0f : z;
            });
        case PassKind::combine:
            return each(
                [&](unsigned axis) { return x[axis] + (pass.scale * y[axis] + pass.bias); });
        case PassKind::multiply:
            return each([&](unsigned axis) { return product(x[axis], y[axis]); });
        case PassKind::isolate:
            return same(x[pass.axis]);
        case PassKind::shift_left:
            return each([&](unsigned axis) {
                return 2.0f * (x[axis] >= 128.0f ? x[axis] - 128.0f : x[axis]);
            });
        case PassKind::blend_bit:
            return each([&](unsigned axis) {
                const float over = pass.colors[x[axis] >= 128.0f ? 1 : 0];
                return std::floor((7.0f * y[axis] + over + 4.0f) * 0.125f);
            });
        case PassKind::hash:
            return same(random_number(pass, i));
        case PassKind::axis_table:
            return same(axis_number(pass, i));
        case PassKind::value_table:
            return each([&](unsigned axis) { return value_number(pass, x[axis]); });
        case PassKind::weigh: {
            const float w = y[pass.axis], weight = pass.upper ? w : (fixed_ ? 255.0f : 1.0f) - w;
            return each([&](unsigned axis) { return product(x[axis], weight); });
        }
        case PassKind::field_index:
            return same(field_index(pass, i));
        default:
            return same(pass.bias);
    }
}

float MultipassModel::solid_code(const Pass& pass, std::size_t texel, unsigned axis) const {
    const std::uint64_t x = coordinate(pass, texel, axis);
    const std::uint32_t cell = std::uint32_t(x >> 32) - pass.bits.base[axis];
    const std::uint32_t place = std::uint32_t(x) >> (32 - pass.bits.fraction());
    return float((cell << pass.bits.fraction() | place) & 255);
}

float MultipassModel::random_number(const Pass& pass, std::size_t texel) const {
    PassIntegers cell;
    for (std::size_t axis = 0; axis < 3; ++axis)
        cell[axis] = fixed_
                         ? (std::uint32_t(images_.at(pass.first)[texel][axis]) & pass.bits.mask()) +
                               pass.bits.base[axis]
                         : integers_.at(pass.first)[texel][axis];
    const std::uint32_t h = LatticeHash::bits(cell, pass.seed);
    if (fixed_) return float(h >> 24 ^ 0x80);
    return float(std::int32_t(h) >> 8) * 0x1p-23f;
}

float MultipassModel::axis_number(const Pass& pass, std::size_t texel) const {
    const std::size_t axis = pass.axis;
    const std::uint32_t step = pass.upper ? 1 : 0;
    const std::uint32_t cell =
        fixed_ ? ((std::uint32_t(images_.at(pass.first)[texel][axis]) + step) & pass.bits.mask()) +
                     pass.bits.base[axis]
               : integers_.at(pass.first)[texel][axis] + step;
    return plan_.tables[pass.table][axis][cell & 255];
}

float MultipassModel::value_number(const Pass& pass, float x) const {
    return plan_.tables[pass.table][3][std::size_t(fixed_ ? x : whole(255.0f * x))];
}

float MultipassModel::field_index(const Pass& pass, std::size_t texel) const {
    const std::uint64_t bits =
        std::uint64_t(maps_[0].cells.pixels()[texel].w) << 32 | maps_[0].places.pixels()[texel].w;
    const double sum = images_.at(pass.first)[texel][0];
    const double noise = fixed_ ? plan_.amplitude * ((sum - 128.0) / 127.5) : sum;
    const double t = map_index(plan_.wrap, (std::bit_cast<double>(bits) + plan_.constant) + noise);
    if (!fixed_) return float(t);
    return plan_.wrap == Wrap::repeat ? float(std::floor(256.0 * t)) : float(255.0 * t);
}

float MultipassModel::product(float a, float b) const {
    return fixed_ ? a * b / 255.0f : flushed(a * b);
}

float MultipassModel::stored(float x) const {
    if (fixed_) return std::clamp(whole(x), 0.0f, 255.0f);
    return plan_.options.precision == PassPrecision::float16 ? half_rounded(x, rounding_) : x;
}

LatticeMap lattice_slice(std::size_t width, std::size_t height, const Affine3& lattice_from_texel) {
    LatticeMap map{{width, height}, {width, height}};
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const Vec3d p = lattice_from_texel(Vec3d(double(x) + 0.5, double(y) + 0.5, 0.0));
            for (int axis = 0; axis < 3; ++axis) {
                const std::uint64_t bits = fixed_point(p[axis]);
                map.cells(x, y)[axis] = std::uint32_t(bits >> 32);
                map.places(x, y)[axis] = std::uint32_t(bits);
            }
        }
    return map;
}

}  // namespace burl
