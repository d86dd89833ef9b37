#pragma once
// Random numbers of whole numbers and of the bits of floats: Bob Jenkins's hash of words,
// lookup3 (2006, in the public domain), with 13 as its initial value, divided by 2^32 - 1.
#include <bit>
#include <cstdint>
#include <initializer_list>

#include "procedural/blender/number.h"

namespace burl::blender {

/// The three words that lookup3 mixes.
struct HashState {
    std::uint32_t a, b, c;

    void take(std::uint32_t& changed, std::uint32_t by, int turn) const {
        changed = (changed ^ by) - std::rotl(by, turn);
    }
    /// The function `mix`.
    void mix() {
        a -= c, a ^= std::rotl(c, 4), c += b;
        b -= a, b ^= std::rotl(a, 6), a += c;
        c -= b, c ^= std::rotl(b, 8), b += a;
        a -= c, a ^= std::rotl(c, 16), c += b;
        b -= a, b ^= std::rotl(a, 19), a += c;
        c -= b, c ^= std::rotl(b, 4), b += a;
    }
    /// The function `final`.
    void finish() {
        take(c, b, 14), take(a, c, 11), take(b, a, 25), take(c, b, 16);
        take(a, c, 4), take(b, a, 14), take(c, b, 24);
    }
};

/// The hash of one to four words.
inline std::uint32_t hash_words(std::initializer_list<std::uint32_t> words) {
    const auto count = std::uint32_t(words.size());
    const std::uint32_t start = 0xdeadbeefu + (count << 2) + 13u;
    HashState state{start, start, start};
    const std::uint32_t* word = words.begin();
    std::uint32_t left = count;
    if (left > 3) {
        state.a += word[0], state.b += word[1], state.c += word[2];
        state.mix();
        word += 3, left -= 3;
    }
    if (left > 2) state.c += word[2];
    if (left > 1) state.b += word[1];
    state.a += word[0];
    state.finish();
    return state.c;
}

/// The random number in [0, 1] of the bits of one to four numbers in float32.
inline double random_of(std::initializer_list<double> numbers) {
    const auto bits = [](double x) { return std::bit_cast<std::uint32_t>(float(x)); };
    const double* n = numbers.begin();
    std::uint32_t word = 0;
    switch (numbers.size()) {
        case 1:
            word = hash_words({bits(n[0])});
            break;
        case 2:
            word = hash_words({bits(n[0]), bits(n[1])});
            break;
        case 3:
            word = hash_words({bits(n[0]), bits(n[1]), bits(n[2])});
            break;
        default:
            word = hash_words({bits(n[0]), bits(n[1]), bits(n[2]), bits(n[3])});
    }
    return double(word) / 4294967295.0;
}

/// The three random numbers of a point.
inline Triple<double> random_triple(const Triple<double>& p) {
    return {random_of({p.x, p.y, p.z}), random_of({p.x, p.y, p.z, 1.0}),
            random_of({p.x, p.y, p.z, 2.0})};
}

}  // namespace burl::blender
