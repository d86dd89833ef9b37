#pragma once
// Random numbers of the bits of floats: the hash of words divided by 2^32 - 1.
#include "procedural/numbers/lookup3.h"
#include "procedural/numbers/numeric.h"

namespace burl::blender {

using namespace numeric;

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
