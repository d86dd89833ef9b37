#include "app/direct/drawn_part.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "app/direct/forward_cube.h"
#include "app/direct/forward_line.h"
#include "app/recipe/edit/recipe_json.h"
#include "procedural/passes/tables.h"

namespace burl {

namespace {

Texture plain_preset(const std::string& name) {
    return *plain_texture(load_recipe(name).texture);
}

Image<Rgb8> cube_part(std::istringstream& words) {
    constexpr std::size_t side = 200;
    std::string recipe, shown;
    double size = 0.0;
    words >> recipe >> size >> shown;
    const Texture texture = plain_preset(recipe);
    Image<Rgb8> forward = draw_cube(texture, size, side, CubeMethod::forward);
    if (shown == "forward") return forward;
    const Image<Rgb8> pixelwise = draw_cube(texture, size, side, CubeMethod::pixelwise);
    return shown == "pixelwise" ? pixelwise : disagreement(pixelwise, forward);
}

/// The plot's octaves: all of the recipe's or the one of that number.
std::vector<Octave> chosen_octaves(const std::string& recipe, const std::string& which) {
    std::vector<Octave> octaves = expand_octaves(plain_preset(recipe));
    if (which == "all") return octaves;
    return {octaves.at(std::stoul(which) - 1)};
}

Image<Rgb8> line_part(std::istringstream& words) {
    std::string recipe, shown, which;
    double largest = 0.0;
    words >> recipe >> shown >> which >> largest;
    const std::vector<Octave> octaves = chosen_octaves(recipe, which);
    const std::vector<double> pixelwise = noise_on_line(octaves, CubeMethod::pixelwise);
    std::vector<double> forward = noise_on_line(octaves, CubeMethod::forward);
    LinePlot plot(largest);
    for (const std::size_t texel : cell_entries(octaves.back())) plot.dash(texel);
    if (shown == "values")
        plot.add_broad(pixelwise);
    else
        std::ranges::transform(forward, pixelwise, forward.begin(), std::minus());
    plot.add_thin(forward);
    return plot.picture();
}

/// A square of 16 x 16 lattice points of the plane r = 0, s to the right and t upwards, with their
/// numbers as greys.
Image<Rgb8> bits_part(std::istringstream& words) {
    constexpr std::size_t cells = 16, cell = 15;
    std::string shown;
    words >> shown;
    const BitRandomizer randomizer = bit_randomizer(1, 4);
    Image<Rgb8> picture(cells * cell, cells * cell);
    for (std::size_t y = 0; y < picture.height(); ++y)
        for (std::size_t x = 0; x < picture.width(); ++x) {
            const std::array<std::uint32_t, 3> point{std::uint32_t(x / cell),
                                                     std::uint32_t(cells - 1 - y / cell), 0};
            const auto code =
                std::uint8_t(shown == "mixed" ? randomizer.mixed(point) : randomizer(point));
            picture(x, y) = {code, code, code};
        }
    return picture;
}

struct DrawnKind {
    std::string_view word;
    Image<Rgb8> (*draw)(std::istringstream&);
};
constexpr std::array drawn_kinds{DrawnKind{"cube", cube_part}, DrawnKind{"line", line_part},
                                 DrawnKind{"bits", bits_part}};

const DrawnKind* kind_of(const std::string& text) {
    const auto found = std::ranges::find(
        drawn_kinds, std::string_view(text).substr(0, text.find(' ')), &DrawnKind::word);
    return found == drawn_kinds.end() ? nullptr : &*found;
}

}  // namespace

bool is_drawn_part(const std::string& text) {
    return kind_of(text) != nullptr;
}

Image<Rgb8> drawn_part(const std::string& text) {
    const DrawnKind& kind = *kind_of(text);
    std::istringstream words(text.substr(kind.word.size()));
    return kind.draw(words);
}

}  // namespace burl
