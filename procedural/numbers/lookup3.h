#pragma once
// Random words of one to four words: Bob Jenkins's hash of words, lookup3 (2006, in the public
// domain), with 13 as its initial value. Blender and MaterialX have their noises from it.
#include <bit>
#include <cstdint>
#include <initializer_list>

namespace burl::numeric {

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

}  // namespace burl::numeric
