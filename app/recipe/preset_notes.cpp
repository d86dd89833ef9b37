#include "app/recipe/preset_notes.h"

#include <algorithm>
#include <array>

namespace burl {

namespace {

constexpr std::array notes{
    PresetNote{"marble", "White marble with dark veins in layers that noise bends."},
    PresetNote{"forming-marble", "Marble whose veins form over time: press K, then Space."},
    PresetNote{"sine-marble", "Brown marble: a sine, bent by turbulence."},
    PresetNote{"pbrt-marble", "The marble of pbrt, its colours on a smooth spline."},
    PresetNote{"bresenham-marble", "Marble of linear noise, which can be made by additions alone."},
    PresetNote{"wood", "Rings of early and late wood round the trunk's axis."},
    PresetNote{"wood-grain", "Wobbling rings and dark pores, stretched along the grain."},
    PresetNote{"bresenham-wood", "Rings of linear noise, which can be made by additions alone."},
    PresetNote{"carved-wood", "Wood whose dark rings are carved in."},
    PresetNote{"planet", "Continents and seas, coloured like a map by their height."},
    PresetNote{"cloudy-planet", "The planet under a layer of clouds."},
    PresetNote{"moon", "Light and dark patches of fractal noise."},
    PresetNote{"night-sky", "Stars over a deep blue that pales downwards."},
    PresetNote{"clouds", "White clouds in a blue sky: four octaves of noise."},
    PresetNote{"moonlit-clouds", "Clouds that let through what is behind them."},
    PresetNote{"windy", "Waves in gusts of wind."},
    PresetNote{"sea", "Long waves, light on dark blue."},
    PresetNote{"moonlit-sea", "Dark water with a path of glitter towards the moon."},
    PresetNote{"fire", "Flames that burn upwards; the phase moves them."},
    PresetNote{"rising-fire", "Fire in motion: press K, then Space."},
    PresetNote{"stripes", "Slanting stripes, bent by noise."},
    PresetNote{"checks", "A checkerboard in space, smooth however far away."},
    PresetNote{"checker-floor", "A checkerboard on a floor."},
    PresetNote{"dots", "Dots strewn at random, laid round like a map on a globe."},
    PresetNote{"zoneplate", "Ever narrower rings, which show how well a filter works."},
    PresetNote{"hammered", "Copper with the dents of a hammer."},
    PresetNote{"orange-peel", "The pores of an orange's peel."},
    PresetNote{"wrinkled", "Turbulence: octaves of noise folded at zero."},
    PresetNote{"noise", "One octave of noise in greys."},
    PresetNote{"noise-slope", "How steep one octave of noise is along a direction."},
};

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

}  // namespace

std::span<const PresetNote> preset_notes() {
    return notes;
}

bool holds_text(std::string_view text, std::string_view part) {
    return part.empty() || std::ranges::search(text, part, {}, lower, lower).begin() != text.end();
}

}  // namespace burl
