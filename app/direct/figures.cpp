#include "app/direct/figures.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/base/messages.h"
#include "app/direct/drawn_part.h"
#include "app/direct/pass_figure.h"
#include "app/direct/picture.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

constexpr std::size_t gap = 4;  // the width in pixels of the white between parts

/// The distance, in radii, of a head-on view in which the middle of a square picture shows
/// [-1,1]^2: 1 / tan(17.5 degrees).
constexpr double unit_distance = 3.171595;

/// A kind of noise, and the amplitude that fills half the range of grey.
struct ShownNoise {
    std::string_view kind;
    double amplitude = 0.5;
};

constexpr std::array shown_noises{ShownNoise{"perlin1985", 0.55}, ShownNoise{"simplex", 1.2},
                                  ShownNoise{"perlin", 0.5}};

/// The arguments for 5 x 5 cells of a noise in the plane z = `place`: its value, or its slope along
/// `direction` where that is not empty.
std::string noise_part(const ShownNoise& noise, std::string_view direction, double place) {
    const bool value = direction.empty();
    std::string line = fmt::format("--plane 0,0,1,{} --view 0,0,{:.4f} --size 100x100 --unlit",
                                   place, 2.5 * unit_distance + place);
    line += value ? " --recipe noise" : " --recipe noise-slope";
    if (!value) line += fmt::format(" --set texture.input.b.b.direction={}", direction);
    const char* term = value ? "texture.input.noise.0" : "texture.input.b.b.input.noise.0";
    return line + fmt::format(" --set {0}.kind={1} --set {0}.amplitude={2}", term, noise.kind,
                              noise.amplitude);
}

Figure noise_figure() {
    Figure figure{"noise-derivatives",
                  "Perlin 2001: old and new noise with their derivatives, at z = 0 and 0.5",
                  6,
                  {}};
    for (const char* direction : {"", "[1,0,0]", "[0,1,0]", "[0,0,1]"})
        for (const double place : {0.0, 0.5})
            for (const ShownNoise& noise : shown_noises)
                figure.parts.push_back(noise_part(noise, direction, place));
    return figure;
}

/// The arguments for 6 x 6 cells of a fractal sum in grey, mapped from [0,1] by amplitude and
/// offset.
std::string sum_part(std::string_view sum, double amplitude, double offset) {
    return fmt::format(
        "--plane 0,0,1,0.3 --view 0,0,9.8148 --size 180x180 --unlit --recipe noise --set "
        "texture.input.noise.0.sum={} --set texture.input.noise.0.octaves=8 --set "
        "texture.input.noise.0.weights=normalized --set texture.input.noise.0.range=unit --set "
        "texture.input.noise.0.amplitude={} --set texture.input.quadric.J={}",
        sum, amplitude, offset);
}

Figure sums_figure() {
    const std::string_view colored = "--plane 0,0,1,0.3 --size 180x180 --unlit";
    return {
        "fractal-sums",
        "fBm, turbulence and ridged noise; Perlin's sums of noise, |noise| and a sine over them",
        3,
        {sum_part("fbm", 2.0, -0.5), sum_part("turbulence", 2.5, 0.0),
         sum_part("ridged", 1.6, -0.5),
         fmt::format("{} --view 0,0,3.5 --recipe clouds --set "
                     "texture.input.noise.0.kind=perlin1985 --set "
                     "texture.input.noise.0.range=unit --set texture.input.noise.0.octaves=8",
                     colored),
         fmt::format("{} --view 0,0,3.5 --recipe wrinkled --set texture.input.kind=perlin1985",
                     colored),
         fmt::format("{} --view 0,0,3.5 --recipe sine-marble", colored)}};
}

/// The arguments for a square of the zone plate seen head on, with the rings' centre in one of its
/// corners (the paper's unit square) or in its middle.
std::string zone_part(bool corner, std::string_view filter) {
    std::string line = fmt::format(
        "--plane 0,0,1,0 --recipe zoneplate --view 0,0,{:.5f} --size 256x256 --unlit "
        "--supersample 1 --filter {}",
        corner ? 0.5 * unit_distance : unit_distance, filter);
    if (corner)
        for (const char* shift : {"D=25", "G=25", "J=25"})
            line += fmt::format(" --set texture.input.quadric.{}", shift);
    return line;
}

Figure cubes_figure() {
    Figure figure{"bresenham-cubes",
                  "Kameya & Hart, figures 4 to 8: wood and marble pixel by pixel, by forward "
                  "differences, and where these differ",
                  3,
                  {}};
    for (const char* cube : {"bresenham-wood 1", "bresenham-marble 2"})
        for (const char* shown : {"pixelwise", "forward", "difference"})
            figure.parts.push_back(fmt::format("cube {} {}", cube, shown));
    return figure;
}

/// Plots of wood's noise on the left, and of marble's four octaves on the right: values and
/// differences (figures 9 and 10); below the differences of one octave, the first and the fourth
/// (figure 11).
Figure lines_figure() {
    return {
        "bresenham-lines",
        "Kameya & Hart, figures 9 to 11: noise along a line by both methods, and what they "
        "differ by",
        2,
        {"line bresenham-wood values all 1", "line bresenham-marble values all 2",
         "line bresenham-wood difference all 2e-7", "line bresenham-marble difference all 5e-7",
         "line bresenham-marble difference 1 1.5e-7", "line bresenham-marble difference 4 2e-8"}};
}

std::string torus_part(std::string_view shown) {
    return fmt::format(
        "sample:torus --recipe wood --set solid.scale=14 --set texture.input.quadric.D=5 --set "
        "texture.input.quadric.J=25 --view 0,55,3.4 --size 300x240 --supersample 1 {}",
        shown);
}

std::string floor_part(std::string_view antialiasing) {
    return fmt::format(
        "--plane 0,1,0,-0.5 --recipe checker-floor --set texture.input.aa={} --view 15,14,3.5 "
        "--size 240x240 --unlit --supersample 1",
        antialiasing);
}

std::vector<std::string> sphere_parts() {
    const std::string_view ball =
        "sample:icosphere --view 30,20,3.3 --size 240x240 --unlit --supersample 2 --recipe noise";
    const auto share = [](std::string_view axis) {
        return fmt::format(R"({{"node":"coordinate","direction":[{}],"offset":0.5}})", axis);
    };
    return {fmt::format(R"({} --set 'texture={{"node":"combine","red":{},"green":{},"blue":{}}}')",
                        ball, share("0.5,0,0"), share("0,0.5,0"), share("0,0,0.5")),
            fmt::format("{} --set texture.input.noise.0.kind=value --set "
                        "texture.input.noise.0.fade=linear --set solid.scale=8 --set "
                        "texture.input.noise.0.range=unit --set texture.input.noise.0.amplitude=1 "
                        "--set texture.input.quadric.J=0",
                        ball)};
}

/// Three frames of the flight over the seascape, without and with the filter. The camera stands
/// still, and the planes' textures come towards it by a tenth of the clouds' height a frame.
Figure flight_figure() {
    Figure figure{
        "seascape-flight",
        "Hart et al. 1999, section 4.4: frames of a flight over the seascape, aliased and "
        "filtered",
        3,
        {}};
    for (const char* filter : {"none", "trapezoid"})
        for (const double way : {0.0, 0.1, 0.2})
            figure.parts.push_back(fmt::format(
                "--plane sea:0,1,0,-0.6 --plane clouds:0,1,0,1 --view 0,-3,3.5 --size 240x180 "
                "--supersample 1 --unlit --filter {} --set sea:solid.translate.2={:.1f} --set "
                "clouds:solid.translate.2={:.1f}",
                filter, 0.0 - 2.0 * way, 0.0 - 3.0 * way));
    return figure;
}

/// Few gates: fewer octaves, interpolated linearly, in numbers of 8.8 bits, and the colour table
/// filtered in the resolution nearest to the footprint.
Figure gates_figure() {
    const std::string_view cheap =
        "--precision fixed:8.8 --filter table-mip --set texture.input.noise.0.fade=linear --set "
        "texture.input.noise.0.octaves={} --size 240x180 --supersample 1";
    const auto part = [&](std::string_view scene, int octaves) {
        return fmt::format("{} {}", scene, fmt::format(fmt::runtime(cheap), octaves));
    };
    return {
        "hundred-thousand-gates",
        "Hart et al. 1999, figure 11: figures 1 to 6 with cheap arithmetic",
        3,
        {part("sample:teapot --recipe wood --set solid.scale=9 --light headlight --view "
              "25,24,2.6",
              1),
         part("sample:teapot --recipe marble --light headlight --view 25,24,2.6", 2),
         part("--plane 0,1,0,1 --recipe clouds --view 0,-12,3.5 --unlit", 2),
         part("--plane 0,1,0,0 --recipe fire --set "
              "'texture.input.noise.0.frequency=[2.5,0,1.2]' --set texture.input.quadric.I=0.25 "
              "--set texture.input.quadric.J=0.15 --view 0,-90,2.6 --unlit",
              2),
         part("sample:icosphere --recipe planet --light headlight --view 180,20,3.6", 4),
         part("sample:icosphere --recipe moon --view 0,-7,3.6 --unlit", 4)}};
}

std::vector<Figure> paper_1999() {
    const std::string_view teapot =
        "--light headlight --view 25,24,2.6 --size 480x360 --supersample 3";
    const std::string_view sky = "--size 480x360 --supersample 3 --unlit";
    return {
        {"wood-teapot",
         "Hart et al. 1999, figure 1: carved wooden teapot",
         1,
         {fmt::format("sample:teapot --recipe wood --set solid.scale=9 --filter trapezoid {}",
                      teapot)}},
        {"marble-teapot",
         "Hart et al. 1999, figure 2: marble teapot sculpture",
         1,
         {fmt::format("sample:teapot --recipe marble --filter trapezoid {}", teapot)}},
        {"seascape",
         "Hart et al. 1999, figure 3: sea and sky without end",
         1,
         {fmt::format("--plane sea:0,1,0,-0.6 --plane clouds:0,1,0,1 --view 0,-3,3.5 {}", sky)}},
        {"fire",
         "Hart et al. 1999, figure 4: fire on a single polygon",
         1,
         {"--plane 0,1,0,0 --recipe fire --set 'texture.input.noise.0.frequency=[2.5,0,1.2]' --set "
          "texture.input.noise.0.octaves=6 --set texture.input.quadric.I=0.25 --set "
          "texture.input.quadric.J=0.15 --view 0,-90,2.6 --size 360x360 --unlit"}},
        {"planet",
         "Hart et al. 1999, figure 5: a planet under its clouds",
         1,
         {"sample:icosphere --recipe cloudy-planet --plane night-sky:0,0,1,20 --light headlight "
          "--view 180,20,3.6 --size 360x360 --supersample 3"}},
        {"moonrise",
         "Hart et al. 1999, figure 6: moonrise",
         1,
         {fmt::format("sample:icosphere --recipe moon --plane night-sky:0,0,1,-20 --plane "
                      "moonlit-clouds:0,0,1,2 --plane moonlit-sea:0,1,0,-1.5 --view 0,-7,9 {}",
                      sky)}},
        {"zone-plate",
         "Hart et al. 1999, figure 8: zone plate aliased and filtered",
         2,
         {zone_part(true, "none"), zone_part(true, "trapezoid"), zone_part(false, "none"),
          zone_part(false, "trapezoid")}},
        {"wood-torus",
         "Hart et al. 1999, figure 9: wood aliased, filtered, and the filter's width",
         3,
         {torus_part("--light headlight --filter none"),
          torus_part("--light headlight --filter trapezoid"), torus_part("--widths --unlit")}}};
}

}  // namespace

std::vector<Figure> figures() {
    std::vector<Figure> all = paper_1999();
    all.push_back(gates_figure());
    all.push_back(flight_figure());
    all.push_back({"noise-passes",
                   "Hart 2001, figures 4 and 6 to 9: what the passes of multipass noise hold", 4,
                   pass_parts()});
    all.push_back({"image-channels",
                   "Hart 2001, figure 5: weights as an image, and its channels one by one", 3,
                   channel_parts()});
    all.push_back({"blended-bits",
                   "Hart 2001, figure 11: numbers blended by bits of coordinates, and by theirs",
                   2,
                   {"bits mixed", "bits numbers"}});
    all.push_back({"noise-sphere", "Hart 2001, figure 13: noise on a sphere of solid coordinates",
                   2, sphere_parts()});
    all.push_back(noise_figure());
    all.push_back(sums_figure());
    all.push_back({"checkers",
                   "pbrt's checkerboard (Chuang 2008): no antialiasing, closed form, supersampled",
                   3,
                   {floor_part("none"), floor_part("closed_form"), floor_part("supersample")}});
    all.push_back(cubes_figure());
    all.push_back(lines_figure());
    return all;
}

bool Figure::has_commands() const {
    return !parts.empty() && !is_drawn_part(parts[0]);
}

Figure find_figure(const std::string& name) {
    std::vector<std::string> names;
    for (const Figure& figure : figures()) {
        if (figure.name == name) return figure;
        names.push_back(figure.name);
    }
    const std::string_view nearest = nearest_word(name, names);
    const std::string hint = nearest.empty() ? "" : fmt::format("did you mean \"{}\"? ", nearest);
    throw Error(ExitCode::usage, fmt::format("there is no figure \"{}\"; {}the figures are {}",
                                             name, hint, fmt::join(names, ", ")));
}

Image<Rgb8> draw_part(const std::string& arguments) {
    if (is_drawn_part(arguments)) return drawn_part(arguments);
    DirectOptions options;
    CLI::App line;
    options.add(line);
    line.parse(arguments);
    return DirectPicture(options)(picture_recipes(options, {}).front());
}

Image<Rgb8> draw_figure(const Figure& figure) {
    const std::size_t columns = figure.columns;
    const std::size_t rows = (figure.parts.size() + columns - 1) / columns;
    Image<Rgb8> whole;
    for (std::size_t i = 0; i < figure.parts.size(); ++i) {
        const Image<Rgb8> part = draw_part(figure.parts[i]);
        const std::size_t width = part.width() + gap, height = part.height() + gap;
        if (i == 0)
            whole = Image<Rgb8>(columns * width - gap, rows * height - gap, Rgb8{255, 255, 255});
        for (std::size_t y = 0; y < part.height(); ++y)
            std::copy_n(
                part.row(y).begin(), part.width(),
                whole.row(i / columns * height + y).begin() + std::ptrdiff_t(i % columns * width));
    }
    return whole;
}

}  // namespace burl
