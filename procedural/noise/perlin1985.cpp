#include "procedural/noise/perlin1985.h"

#include <utility>

namespace burl {

namespace {

/// random() of GNU libc: an additive lagged generator, x_i = x_{i-3} + x_{i-31} modulo 2^32 without
/// its lowest bit, started by the minimal standard generator (16807) and run 310 steps.
class LibraryRandom {
  public:
    explicit LibraryRandom(std::uint32_t seed) {
        std::int64_t word = seed == 0 ? 1 : std::int32_t(seed);
        for (std::uint32_t& x : state_) {
            x = std::uint32_t(word);
            word = positive_remainder(16807 * std::int64_t(std::int32_t(word)), 2147483647);
        }
        for (int i = 0; i < 310; ++i) (*this)();
    }
    std::uint32_t operator()() {
        const std::uint32_t sum = state_[at_] += state_[(at_ + 28) % state_.size()];
        at_ = (at_ + 1) % state_.size();
        return sum >> 1;
    }

  private:
    std::array<std::uint32_t, 31> state_{};
    std::size_t at_ = 3;  ///< index of x_{i-31}, which x_i replaces; x_{i-3} lies three before it
};

/// Fills v with numbers uniform in [-1, 1), in steps of 1/256.
template <std::size_t N>
void draw(LibraryRandom& random, std::array<float, N>& v) {
    for (float& x : v) x = float(int(random() % 512) - 256) / 256.0f;
}

/// Scales v to length 1, as the appendix does: squares are added in float32, and the root is
/// rounded to float32.
template <std::size_t N>
void normalize(std::array<float, N>& v) {
    float squares = 0.0f;
    for (const float x : v) squares += x * x;
    const auto length = float(std::sqrt(double(squares)));
    for (float& x : v) x = length > 0.0f ? x / length : 0.0f;
}

}  // namespace

ClassicTables::ClassicTables(std::uint32_t seed) {
    LibraryRandom random(seed);
    for (std::uint32_t i = 0; i < 256; ++i) {
        p[i] = i;
        draw(random, g1[i]);
        draw(random, g2[i]);
        normalize(g2[i]);
        draw(random, g3[i]);
        normalize(g3[i]);
    }
    for (std::size_t i = 255; i > 0; --i) std::swap(p[i], p[random() % 256]);
}

const ClassicTables& classic_tables() {
    static const ClassicTables tables(1);
    return tables;
}

}  // namespace burl
