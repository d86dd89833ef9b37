#pragma once
// The sums of noise (noise/hashed_perlin.h) that Blender's Noise and Musgrave textures are.
// Musgrave's are those of Ebert, Musgrave, Peachey, Perlin, Worley, "Texturing and Modeling",
// chapter 16.
#include <algorithm>
#include <cstdint>

#include "procedural/blender/hash.h"
#include "procedural/noise/hashed_perlin.h"

namespace burl::blender {

/// The noise at p, about -1 to 1; 0 where a coordinate is not finite or beyond 2^30 cells.
template <class T>
T noise(const Triple<T>& p) {
    return hashed_noises<1>(p).front();
}

/// The noise of noise(), moved to the range from 0 to 1.
template <class T>
T unit_noise(const Triple<T>& p) {
    return T(0.5) * noise(p) + T(0.5);
}

/// The mean of octaves of frequencies 1, 2, 4, ... and weights 1, r, r^2, ..., from 0 to 1:
/// `detail` octaves and one; of a detail that is no whole number a blend of the two next to it.
template <class T>
T fractal(Triple<T> p, const T& detail, const T& roughness) {
    const T octaves = clamped(detail, 0.0, 15.0), r = clamped(roughness);
    const int whole = int(value_of(octaves));
    T sum = T(0.0), weight = T(1.0), weights = T(0.0);
    for (int k = 0; k <= whole; ++k) {
        sum = sum + weight * unit_noise(p);
        weights = weights + weight;
        weight = weight * r;
        p = p + p;
    }
    const T part = octaves - T(double(whole)), mean = quotient(sum, weights);
    if (value_of(part) == 0.0) return mean;
    const T more = quotient(sum + weight * unit_noise(p), weights + weight);
    return blended(part, mean, more);
}

/// The offset by which a noise stands for another one, as three numbers between 100 and 200.
inline Triple<double> noise_offset(double seed) {
    const auto one = [seed](double axis) { return 100.0 + 100.0 * random_of({seed, axis}); };
    return {one(0.0), one(1.0), one(2.0)};
}

/// Blender's Noise texture: a value, and a colour whose red is the value.
template <class T>
Triple<T> noise_texture(Triple<T> p, const T& detail, const T& roughness, const T& distortion,
                        bool color) {
    const auto shifted = [](const Triple<T>& at, double seed) {
        return at + constants<T>(noise_offset(seed));
    };
    if (value_of(distortion) != 0.0) {
        const Triple<T> way{noise(shifted(p, 0.0)), noise(shifted(p, 1.0)), noise(shifted(p, 2.0))};
        p = p + times(distortion, way);
    }
    Triple<T> result;
    result.x = fractal(p, detail, roughness);
    if (!color) return result;
    result.y = fractal(shifted(p, 3.0), detail, roughness);
    result.z = fractal(shifted(p, 4.0), detail, roughness);
    return result;
}

/// The numbers that Musgrave's functions share.
template <class T>
struct MusgraveSum {
    T detail, dimension, lacunarity, offset, gain;
};

enum class MusgraveKind { multifractal, ridged, hybrid, fbm, hetero_terrain };

/// The weight of an octave's signal from which on Musgrave's hybrid ends: smaller ones do not show.
constexpr double least_carry(MusgraveKind kind) {
    return kind == MusgraveKind::hybrid ? 0.001 : -1.0;
}

/// Musgrave's function of that kind at p.
template <class T>
T musgrave(MusgraveKind kind, Triple<T> p, const MusgraveSum<T>& sum) {
    const T lacunarity = larger(sum.lacunarity, T(1e-5)), octaves = clamped(sum.detail, 0.0, 15.0);
    const T step = raised(lacunarity, T(0.0) - larger(sum.dimension, T(1e-5)));
    const double counted = std::floor(value_of(octaves));
    const bool hetero = kind == MusgraveKind::hetero_terrain, ridged = kind == MusgraveKind::ridged;
    // These two have a first octave whatever the detail, and ridged leaves out parts of octaves.
    const int whole = int(std::max(counted, hetero || ridged ? 1.0 : 0.0));
    const T part = ridged ? T(0.0) : octaves - T(counted);
    T weight = T(1.0), value = T(kind == MusgraveKind::multifractal ? 1.0 : 0.0), carry = T(1.0);
    for (int k = 0; k <= whole; ++k) {
        const T share = k < whole ? T(1.0) : part;
        if (value_of(share) == 0.0 || !(value_of(carry) > least_carry(kind))) break;
        const T n = noise(p);
        switch (kind) {
            case MusgraveKind::multifractal:
                value = value * (share * weight * n + T(1.0));
                break;
            case MusgraveKind::fbm:
                value = value + share * weight * n;
                break;
            case MusgraveKind::hetero_terrain:
                value = k == 0 ? sum.offset + n : value + share * weight * (n + sum.offset) * value;
                break;
            case MusgraveKind::hybrid: {
                carry = k == 0 ? carry : smaller(carry, T(1.0));
                const T signal = weight * (n + sum.offset);
                value = value + share * carry * signal;
                carry = carry * sum.gain * signal;
                break;
            }
            case MusgraveKind::ridged: {
                const T ridge = sum.offset - absolute(n);
                const T signal = k == 0 ? ridge * ridge : carry * ridge * ridge;
                value = value + weight * signal;
                carry = clamped(signal * sum.gain);
                break;
            }
        }
        weight = weight * step;
        p = times(lacunarity, p);
    }
    return value;
}

}  // namespace burl::blender
