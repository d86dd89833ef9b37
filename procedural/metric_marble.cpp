#include "procedural/metric_marble.h"

#include <array>
#include <cmath>
#include <numbers>

#include "procedural/noise.h"

namespace burl {

namespace {

/// Perlin's published permutation of 0..255.
constexpr std::array<std::uint8_t, 256> published_permutation{
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103,
    30,  69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,
    197, 62,  94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174,
    20,  125, 136, 171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231,
    83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143,
    54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196,
    135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124,
    123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,
    182, 189, 28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101,
    155, 167, 43,  172, 9,   129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185,
    112, 104, 218, 246, 97,  228, 251, 34,  242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,
    51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,  181, 199, 106, 157, 184, 84,  204, 176,
    115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114, 67,  29,  24,  72,  243,
    141, 128, 195, 78,  66,  215, 61,  156, 180};

std::uint32_t permuted(std::uint32_t i) {
    return published_permutation[i & 255];
}

}  // namespace

double published_perlin_noise(const Vec3d& p) {
    return perlin_noise(p, [](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        return permuted(permuted(permuted(i) + j) + k) & 15;
    });
}

double metric_marble(const Vec3d& s) {
    const Vec3d p = s + Vec3d(0.013, 0.027, 0.041);
    double f = 2.0 * p.z, frequency = 2.0, amplitude = 1.0;
    for (int i = 0; i < 4; ++i, frequency *= 2.0, amplitude *= 0.5)
        f += amplitude * published_perlin_noise(frequency * p);
    return 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * f));
}

}  // namespace burl
