#include "procedural/passes/plan.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

namespace burl {

namespace {

using enum PassImage;

/// The passes of octaves, one after the other; docs/reference/opengl.md counts them.
class Planner {
  public:
    explicit Planner(MultipassPlan& plan)
        : plan_(plan), fixed_(plan.options.precision == PassPrecision::fixed8) {}

    void begin() { fill(sum, fixed_ ? 128.0f : 0.0f); }

    void add(const MultipassOctave& octave) {
        octave_ = octave;
        make_random_numbers();
        if (fixed_)
            split_fixed();
        else
            split();
        if (octave.fade == Fade::smooth) s_curve();
        fill(noise, 0.0f);
        for (unsigned corner = 0; corner < 8; ++corner) add_corner(corner);
        add_noise();
    }

    void end() { add(PassKind::field_index, index, sum).stream = 0; }

  private:
    Pass& add(PassKind kind, PassImage target, PassImage first = none, PassImage second = none) {
        Pass pass;
        pass.kind = kind, pass.target = target, pass.first = first, pass.second = second;
        pass.stream = octave_.stream, pass.doublings = octave_.doublings;
        pass.seed = octave_.seed, pass.bits = octave_.bits;
        return plan_.passes.emplace_back(pass);
    }
    void fill(PassImage target, float value) { add(PassKind::fill, target).bias = value; }
    void transfer(PassImage target, PassImage first, float scale, float bias) {
        Pass& pass = add(PassKind::transfer, target, first);
        pass.scale = scale, pass.bias = bias;
    }
    void combine(PassImage target, PassImage second, float scale = 1.0f, float bias = 0.0f) {
        Pass& pass = add(PassKind::combine, target, target, second);
        pass.scale = scale, pass.bias = bias;
    }

    void make_random_numbers() {
        if (plan_.options.randomizer == Randomizer::table) {
            plan_.tables.push_back(random_tables(octave_.seed));
            for (std::size_t i = 0; i < 4; ++i)
                for (float& number : plan_.tables.back()[i]) number = held(number, i == 3);
        }
        if (plan_.options.randomizer != Randomizer::bits) return;
        bits_ = bit_randomizer(octave_.seed, octave_.bits.integer);
        if (plan_.options.equalize) plan_.tables.push_back({{{}, {}, {}, equal_table(bits_)}});
    }
    /// A number of a table in the form that images hold; `last` marks the fourth table.
    float held(float number, bool last) const {
        if (last) return fixed_ ? 128.0f * number + 127.5f : number;
        return fixed_ ? number : number / 255.0f;
    }

    void split() {
        add(PassKind::cells, integers);
        if (plan_.options.randomizer == Randomizer::hash)
            add(PassKind::step, integers_up, integers);
        add(PassKind::places, weights);
    }

    /// The papers' solid_int = solid_map >> b_f and weight = solid_map - (solid_int << b_f), scaled
    /// up to 1 by PixelTransfer, or shifted left bit by bit by register combiners.
    void split_fixed() {
        const unsigned whole = octave_.bits.integer, part = octave_.bits.fraction();
        const bool by_bits = plan_.options.randomizer == Randomizer::bits;
        const auto ones = float((1u << part) - 1);
        add(PassKind::solid_map, solid);
        shift_right(integers, solid, part, by_bits);
        if (plan_.options.randomizer == Randomizer::hash)
            transfer(integers_up, integers, 1.0f, 1.0f);
        shift_left(shifted, integers, part, by_bits);
        if (by_bits) {
            transfer(shifted_up, shifted, 1.0f, ones + 1.0f);
            plan_.passes.back().wraps = true;
        }
        add(PassKind::combine, weights, solid, shifted).scale = -1.0f;
        if (by_bits)
            shift_left(weights, weights, whole, true);
        else
            transfer(weights, weights, 255.0f / ones, 0.0f);
    }
    /// Divides by 2^bits and rounds down: bit by bit, or at once.
    void shift_right(PassImage target, PassImage first, unsigned bits, bool by_bits) {
        if (!by_bits) {
            const float scale = std::ldexp(1.0f, -int(bits));
            return transfer(target, first, scale, 0.5f * scale - 0.5f);
        }
        for (unsigned bit = 0; bit < bits; ++bit)
            transfer(target, bit == 0 ? first : target, 0.5f, -0.25f);
    }
    void shift_left(PassImage target, PassImage first, unsigned bits, bool by_bits) {
        if (!by_bits) return transfer(target, first, std::ldexp(1.0f, int(bits)), 0.0f);
        for (unsigned bit = 0; bit < bits; ++bit)
            add(PassKind::shift_left, target, bit == 0 ? first : target);
    }

    /// The fade 3u^2 - 2u^3 = 4 u u (3/4 - u/2): the last factor, and the product before the last
    /// step, lie in [0, 1].
    void s_curve() {
        transfer(ramp, weights, -0.5f, fixed_ ? 191.25f : 0.75f);
        add(PassKind::multiply, ramp, ramp, weights);
        add(PassKind::multiply, ramp, ramp, weights);
        transfer(weights, ramp, 4.0f, 0.0f);
    }

    void add_corner(unsigned number) {
        const std::array<bool, 3> upper{(number & 1) != 0, (number & 2) != 0, (number & 4) != 0};
        if (plan_.options.randomizer == Randomizer::hash)
            randomize_by_hash(upper);
        else if (plan_.options.randomizer == Randomizer::table)
            randomize_by_tables(upper);
        else
            randomize_by_bits(upper);
        for (unsigned axis = 0; axis < 3; ++axis) {
            Pass& pass = add(PassKind::weigh, corner, corner, weights);
            pass.axis = axis, pass.upper = upper[axis];
        }
        combine(noise, corner);
    }

    void randomize_by_hash(const std::array<bool, 3>& upper) {
        add(PassKind::copy, cell, integers);
        if (upper[0] || upper[1] || upper[2]) add(PassKind::copy, cell, integers_up).mask = upper;
        add(PassKind::hash, corner, cell);
    }

    void randomize_by_tables(const std::array<bool, 3>& upper) {
        const std::array parts{part_s, part_t, part_r};
        for (unsigned axis = 0; axis < 3; ++axis) {
            Pass& pass = add(PassKind::axis_table, parts[axis], integers);
            pass.axis = axis, pass.upper = upper[axis], pass.table = plan_.tables.size() - 1;
        }
        transfer(corner, part_s, 1.0f, 0.0f);
        combine(corner, part_t);
        combine(corner, part_r);
        look_up();
    }
    void look_up() { add(PassKind::value_table, corner, corner).table = plan_.tables.size() - 1; }

    void randomize_by_bits(const std::array<bool, 3>& upper) {
        const std::array parts{part_s, part_t, part_r};
        for (unsigned axis = 0; axis < 3; ++axis)
            add(PassKind::isolate, parts[axis], upper[axis] ? shifted_up : shifted).axis = axis;
        fill(mixed, blend_start);
        for (unsigned bit = 0; bit < bits_.bits; ++bit)
            for (unsigned axis = 0; axis < 3; ++axis) {
                blend(mixed, parts[axis], bits_.coordinates[3 * bit + axis]);
                if (bit + 1 < bits_.bits) add(PassKind::shift_left, parts[axis], parts[axis]);
            }
        fill(corner, blend_start);
        for (unsigned bit = 0; bit < 8; ++bit) {
            blend(corner, mixed, bits_.result[bit]);
            if (bit < 7) add(PassKind::shift_left, mixed, mixed);
        }
        if (plan_.options.equalize) look_up();
    }
    void blend(PassImage target, PassImage by, const BitColors& colors) {
        add(PassKind::blend_bit, target, by, target).colors = colors.luminance;
    }

    void add_noise() {
        if (fixed_) {
            const auto part = float(octave_.scale / plan_.amplitude);
            combine(sum, noise, part, -127.5f * part);
        } else {
            combine(sum, noise, float(octave_.scale));
        }
    }

    MultipassPlan& plan_;
    bool fixed_;
    MultipassOctave octave_;
    BitRandomizer bits_;
};

/// x, or 0 where it is NaN or beyond the lattice.
double in_reach(double x) {
    return std::abs(x) < lattice_limit ? x : 0.0;
}

}  // namespace

LatticeBits lattice_bits(const LatticeBox& box, int doublings) {
    double cells = 2.0;
    LatticeBits bits;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = std::floor(std::ldexp(in_reach(box.low[axis]), doublings));
        const double high = std::floor(std::ldexp(in_reach(box.high[axis]), doublings));
        bits.base[std::size_t(axis)] = std::uint32_t(std::int64_t(std::fmod(low, 0x1p32)));
        cells = std::max(cells, high - low + 1.0);
    }
    bits.repeats = cells > 128.0;
    bits.integer = unsigned(std::bit_width(std::uint32_t(std::min(cells, 128.0)) - 1));
    return bits;
}

std::string no_multipass_form(std::span<const Octave> octaves, const MultipassOptions& options) {
    const bool fixed = options.precision == PassPrecision::fixed8;
    if (options.randomizer == Randomizer::bits && !fixed)
        return "the randomizer bits shifts 8-bit images; add --gl-precision 8";
    if (options.equalize && options.randomizer != Randomizer::bits)
        return "--gl-equalize makes the Gaussian numbers of --gl-randomizer bits white; the others "
               "are white already";
    for (const Octave& octave : octaves)
        if (!has_kernel(octave) || octave.noise.kind != NoiseKind::value ||
            octave.noise.fade == Fade::quintic)
            return "the papers' passes are of value noise with the linear or the smooth fade, "
                   "without period, time or shape";
    return "";
}

std::vector<MultipassOctave> multipass_octaves(std::span<const OctaveGroup> groups,
                                               std::span<const LatticeBox> boxes) {
    std::vector<MultipassOctave> octaves;
    for (std::size_t stream = 0; stream < groups.size(); ++stream) {
        const OctaveGroup& group = groups[stream];
        for (std::size_t k = group.octaves.size(); k-- > 0;) {
            const StreamOctave& octave = group.octaves[k];
            octaves.push_back({group.fade, octave.seed, stream, octave.doublings,
                               group.scale * double(octave.weight)});
            if (stream < boxes.size())
                octaves.back().bits = lattice_bits(boxes[stream], octave.doublings);
        }
    }
    return octaves;
}

MultipassPlan plan_multipass(const MultipassOptions& options,
                             std::span<const MultipassOctave> octaves, double constant, Wrap wrap) {
    MultipassPlan plan;
    plan.options = options, plan.constant = constant, plan.wrap = wrap;
    if (!octaves.empty()) plan.amplitude = 0.0;
    for (const MultipassOctave& octave : octaves) plan.amplitude += std::abs(octave.scale);
    Planner planner(plan);
    planner.begin();
    for (const MultipassOctave& octave : octaves) planner.add(octave);
    planner.end();
    return plan;
}

std::size_t count_passes(std::span<const Pass> passes) {
    return passes.size() - std::size_t(std::ranges::count(passes, PassKind::fill, &Pass::kind));
}

std::size_t passes_of_octave(const MultipassOptions& options, const MultipassOctave& octave) {
    return count_passes(plan_multipass(options, {&octave, 1}, 0.0, Wrap::repeat).passes) - 1;
}

std::string words_of(const Pass& pass) {
    std::string words = fmt::format("{}: {}", to_string(pass.kind), to_string(pass.target));
    std::ranges::replace(words, '_', ' ');
    return words;
}

bool holds_integers(PassImage image, PassPrecision precision) {
    return precision != PassPrecision::fixed8 &&
           (image == integers || image == integers_up || image == cell);
}

}  // namespace burl
