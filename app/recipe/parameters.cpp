#include "app/recipe/parameters.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace burl {

namespace {

using enum ParameterType;

// path, type, low, high, step, count, unit, default, choices, tip
constexpr Parameter quadric_parameter(std::string_view path, std::string_view tip) {
    return {path, number, -1e9, 1e9, 0.05, 1, "", "0", "", tip};
}

constexpr std::array table{
    Parameter{"burl", integer, 1, 1, 1, 1, "", "1", "", "version of this format"},
    Parameter{"name", text, 0, 0, 0, 1, "", "\"\"", "", "what the texture is called"},
    Parameter{"atlas.kind", choice, 0, 0, 0, 1, "", "\"patch\"", "uniform|area|length|quad|patch",
              "how triangles are packed"},
    Parameter{"atlas.size", integer, 1, 16384, 256, 1, "texels", "1024", "",
              "width and height of the texture; quad: a power of two"},
    Parameter{"atlas.overscan", choice, 0, 0, 0, 1, "", "\"bilinear\"", "nearest|bilinear",
              "the look-up the texture is prepared for"},
    Parameter{"atlas.weight", choice, 0, 0, 0, 1, "", "\"error\"", "equal|area|length|error",
              "what a pair's share of a quad atlas follows; the other kinds ignore it"},
    Parameter{"atlas.partition", choice, 0, 0, 0, 1, "", "\"rcb\"", "rcb|graph",
              "how a quad atlas finds clusters: by bisecting coordinates, or the graph of "
              "neighbouring pairs"},
    Parameter{"atlas.gutter", integer, 0, 64, 1, 1, "texels", "0", "",
              "quad, bilinear: texels round every pair that go on with its triangles; fewer in "
              "small blocks"},
    Parameter{"atlas.diagonals", choice, 0, 0, 0, 1, "", "\"shared\"", "shared|overscan",
              "quad, bilinear: whether pairs meet on the diagonal, or lie apart where they would "
              "meet in a kink"},
    Parameter{"atlas.tries", integer, 1, 6, 1, 1, "", "4", "",
              "partitions a patch atlas is chosen from; the other kinds ignore it"},
    Parameter{"solid.space", choice, 0, 0, 0, 1, "", "\"unit\"", "unit|object",
              "unit: the mesh's box centred, longest side 1; object: the file's coordinates"},
    Parameter{"solid.scale", number, 1e-6, 1e6, 0.1, 1, "", "1", "",
              "solid coordinates are multiplied by it"},
    Parameter{"solid.rotate", numbers, -360, 360, 4.5, 3, "degrees", "[0,0,0]", "",
              "turns solid coordinates about x, then y, then z, before the scale"},
    Parameter{"solid.translate", numbers, -1e6, 1e6, 0.05, 3, "", "[0,0,0]", "",
              "added to solid coordinates after the scale"},
    Parameter{"texture.node", choice, 0, 0, 0, 1, "", "\"color_map\"", "color_map",
              "kind of the tree's root"},
    Parameter{"texture.wrap", choice, 0, 0, 0, 1, "", "\"repeat\"", "repeat|clamp",
              "the map's index modulo one, or clamped to [0,1]"},
    Parameter{"texture.stops.*.0", number, 0, 1, 0.01, 1, "", "", "",
              "index of a stop, not below the stop before it"},
    Parameter{"texture.stops.*.1", color, 0, 0, 0, 1, "", "", "", "sRGB colour of a stop"},
    Parameter{"texture.input.node", choice, 0, 0, 0, 1, "", "\"field\"", "field",
              "kind of the node that gives the index"},
    quadric_parameter("texture.input.quadric.A", "coefficient of s^2"),
    quadric_parameter("texture.input.quadric.B", "half the coefficient of s t"),
    quadric_parameter("texture.input.quadric.C", "half the coefficient of s r"),
    quadric_parameter("texture.input.quadric.D", "half the coefficient of s"),
    quadric_parameter("texture.input.quadric.E", "coefficient of t^2"),
    quadric_parameter("texture.input.quadric.F", "half the coefficient of t r"),
    quadric_parameter("texture.input.quadric.G", "half the coefficient of t"),
    quadric_parameter("texture.input.quadric.H", "coefficient of r^2"),
    quadric_parameter("texture.input.quadric.I", "half the coefficient of r"),
    quadric_parameter("texture.input.quadric.J", "constant"),
    Parameter{"texture.input.noise.*.kind", choice, 0, 0, 0, 1, "", "\"value\"",
              "value|perlin|perlin2002|perlin1985|simplex|worley|cell|white",
              "which noise; docs/reference/noise.md defines them"},
    Parameter{"texture.input.noise.*.fade", choice, 0, 0, 0, 1, "", "\"smooth\"",
              "linear|smooth|quintic", "interpolation between lattice points; value noise only"},
    Parameter{"texture.input.noise.*.feature", choice, 0, 0, 0, 1, "", "\"f1\"", "f1|f2|f2-f1",
              "distance to the nearest or the second nearest point, or their difference; worley "
              "only"},
    Parameter{"texture.input.noise.*.radius2", number, 0.1, 0.6, 0.05, 1, "", "0.6", "",
              "squared radius of the kernels; simplex only, continuous up to 0.5"},
    Parameter{"texture.input.noise.*.period", numbers, 0, 1073741824, 1, 3, "cells", "[0,0,0]", "",
              "whole cells of the first octave after which the noise repeats; 0: never"},
    Parameter{"texture.input.noise.*.time", number, -1e9, 1e9, 0.1, 1, "cells", "", "",
              "fourth lattice coordinate, the same in every octave; left out: noise of three "
              "dimensions"},
    Parameter{"texture.input.noise.*.time_period", integer, 0, 1073741824, 1, 1, "cells", "0", "",
              "whole cells along time after which the noise repeats; 0: never"},
    Parameter{"texture.input.noise.*.sum", choice, 0, 0, 0, 1, "", "\"fbm\"",
              "fbm|turbulence|ridged", "what octaves add: n, |n| or (1 - |n|)^2"},
    Parameter{"texture.input.noise.*.weights", choice, 0, 0, 0, 1, "", "\"raw\"", "raw|normalized",
              "normalized: amplitudes are divided by the sum of gain^k"},
    Parameter{"texture.input.noise.*.range", choice, 0, 0, 0, 1, "", "", "unit|signed",
              "n from 0 or about 0; left out: unit for value, worley, turbulence and ridged"},
    Parameter{"texture.input.noise.*.amplitude", number, -1e6, 1e6, 0.05, 1, "", "1", "",
              "factor of the first octave"},
    Parameter{"texture.input.noise.*.frequency", numbers, -1e6, 1e6, 0.1, 3, "", "[1,1,1]", "",
              "lattice cells per unit of s, t and r"},
    Parameter{"texture.input.noise.*.phase", numbers, -1e9, 1e9, 0.1, 3, "cells", "[0,0,0]", "",
              "added to the lattice coordinates of every octave, never scaled"},
    Parameter{"texture.input.noise.*.matrix", numbers, -1e9, 1e9, 0.1, 12, "", "", "",
              "3 rows of 4: affine map to lattice coordinates in place of frequency and phase"},
    Parameter{"texture.input.noise.*.seed", integer, 0, 4294967295.0, 1, 1, "", "0", "",
              "number of the random lattice; octave k uses seed + k"},
    Parameter{"texture.input.noise.*.octaves", integer, 1, 24, 1, 1, "", "1", "",
              "how many octaves are summed"},
    Parameter{"texture.input.noise.*.lacunarity", number, 0.01, 16, 0.05, 1, "", "2", "",
              "frequency ratio from one octave to the next"},
    Parameter{"texture.input.noise.*.gain", number, 0, 2, 0.05, 1, "", "0.5", "",
              "amplitude ratio from one octave to the next"},
    Parameter{"bump.height", number, -1e6, 1e6, 0.001, 1, "solid units", "0.01", "",
              "rise of the surface where bump.input grows by 1; solid.scale does not change it"},
    Parameter{"filter.kind", choice, 0, 0, 0, 1, "", "\"none\"",
              "none|table-mip|table-sat|table-sat3|exact|trapezoid|trapezoid2|supersample",
              "how a texel's area is averaged"},
    Parameter{"filter.samples", integer, 1, 1024, 1, 1, "", "16", "",
              "supersample: places per texel; squares are spread best"},
    Parameter{"filter.octaves", choice, 0, 0, 0, 1, "", "\"keep\"", "keep|fade",
              "fade: octaves finer than a texel are left out, the last one in part"},
    Parameter{
        "precision.kind", choice, 0, 0, 0, 1, "", "", "float32|float64|fixed",
        "arithmetic of the texture; left out: float32 for bakes, float64 for render --direct"},
    Parameter{"precision.integer_bits", integer, 1, 16, 1, 1, "bits", "8", "",
              "fixed: bits before the point, the sign's among them"},
    Parameter{"precision.fraction_bits", integer, 2, 16, 1, 1, "bits", "8", "",
              "fixed: bits after the point"},
    Parameter{"paint.*.mode", choice, 0, 0, 0, 1, "", "\"paint\"", "paint|erase",
              "erase: takes away the paint of the strokes before it"},
    Parameter{"paint.*.color", color, 0, 0, 0, 1, "", "\"#000000\"", "", "sRGB colour"},
    Parameter{"paint.*.radius", number, 1e-6, 1e6, 0.005, 1, "solid units", "0.05", "",
              "of the ball that is moved along the points; solid.scale does not change it"},
    Parameter{"paint.*.hardness", number, 0, 1, 0.05, 1, "", "0.5", "",
              "share of the radius that is covered evenly; from there on less and less"},
    Parameter{"paint.*.opacity", number, 0, 1, 0.05, 1, "", "1", "",
              "share of the stroke's colour where it covers most"},
    Parameter{"paint.*.points.*", numbers, -1e9, 1e9, 0.01, 3, "solid units", "", "",
              "a point of the stroke's line, before solid.scale"},
    Parameter{"pose.weight", number, 0, 1, 0.05, 1, "", "1", "",
              "of a mesh with a pose, how far it has gone there; the texture sticks to it"},
    Parameter{"animation.seconds", number, 0.01, 3600, 0.1, 1, "s", "2", "",
              "how long the animation is"},
    Parameter{"animation.rate", integer, 1, 240, 1, 1, "frames/s", "24", "",
              "frames a second of the editor's clock and of frames that it exports"},
    Parameter{"animation.end", choice, 0, 0, 0, 1, "", "\"stop\"", "stop|loop",
              "loop: the end is the beginning, and no frame is made of it"},
    Parameter{"animation.tracks.*.path", text, 0, 0, 0, 1, "", "", "",
              "the number that changes, as --set takes it; nothing of the atlas"},
    Parameter{"animation.tracks.*.ease", choice, 0, 0, 0, 1, "", "\"linear\"", "linear|smooth",
              "how it goes from key to key; smooth: at rest in every key"},
    Parameter{"animation.tracks.*.keys.*.0", number, 0, 3600, 0.1, 1, "s", "", "",
              "when a key is, later than the key before it"},
    Parameter{"animation.tracks.*.keys.*.1", number, -1e9, 1e9, 0.1, 1, "", "", "",
              "what the number is then, within its own range"},
};

/// Levenshtein's distance: insertions, deletions and replacements of single characters.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t(0));
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
        }
    }
    return row[b.size()];
}

}  // namespace

std::span<const Parameter> parameters() {
    return table;
}

std::string_view to_string(ParameterType type) {
    constexpr std::array<std::string_view, 6> names{"number", "integer", "numbers",
                                                    "text",   "choice",  "color"};
    return names[std::size_t(type)];
}

std::vector<std::string_view> split_choices(std::string_view choices) {
    std::vector<std::string_view> words;
    while (!choices.empty()) {
        const std::size_t end = std::min(choices.find('|'), choices.size());
        words.push_back(choices.substr(0, end));
        choices.remove_prefix(std::min(end + 1, choices.size()));
    }
    return words;
}

std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates) {
    std::string_view nearest;
    std::size_t best = std::string_view::npos;
    for (const std::string_view candidate : candidates) {
        const std::size_t distance = edit_distance(word.substr(0, 200), candidate);
        if (distance < best && 2 * distance <= std::max(word.size(), candidate.size()))
            best = distance, nearest = candidate;
    }
    return nearest;
}

}  // namespace burl
