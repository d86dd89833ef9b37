#pragma once
// The names of noises in recipes, on the command line and in `burl list noises`.
#include <array>
#include <string_view>

#include "procedural/noise/fractal_sum.h"
#include "procedural/noise/spec.h"

namespace burl {

/// A value with its name and, for `burl list`, a line of explanation.
template <class T>
struct Named {
    std::string_view name;
    T value;
    std::string_view text = "";
};

inline constexpr std::array noise_kinds{
    Named{"value", NoiseKind::value, "interpolated lattice values; fade linear, smooth or quintic"},
    Named{"perlin", NoiseKind::perlin, "improved Perlin gradient noise (2002)"},
    Named{"perlin2002", NoiseKind::perlin2002,
          "improved Perlin gradient noise with his published permutation (2002)"},
    Named{"perlin1985", NoiseKind::perlin1985, "Perlin's original gradient noise and tables"},
    Named{"simplex", NoiseKind::simplex, "Perlin's simplex noise with bit-pattern hash (2001)"},
    Named{"worley", NoiseKind::worley,
          "distance to random points; feature f1, f2 or f2-f1 (Worley 1996)"},
    Named{"cell", NoiseKind::cell, "one random number for every lattice cell"},
    Named{"white", NoiseKind::white, "one random number for every point"}};

inline constexpr std::array fade_names{Named{"linear", Fade::linear}, Named{"smooth", Fade::smooth},
                                       Named{"quintic", Fade::quintic}};

inline constexpr std::array feature_names{Named{"f1", WorleyFeature::f1},
                                          Named{"f2", WorleyFeature::f2},
                                          Named{"f2-f1", WorleyFeature::f2_f1}};

inline constexpr std::array sum_names{Named{"fbm", OctaveShape::plain},
                                      Named{"turbulence", OctaveShape::absolute},
                                      Named{"ridged", OctaveShape::ridged}};

}  // namespace burl
