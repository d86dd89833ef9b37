// The papers' figures: what must hold whatever they look like, and that the page tells their truth.
#include "app/direct/figures.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "app/image/image_io.h"
#include "app/image/palette.h"
#include "app/scene/shading.h"
#include "atlas/base/error.h"
#include "procedural/color/srgb.h"
#include "tests/app/programs/run_program.h"
#include "tests/paths.h"

namespace burl {
namespace {

using test::run_burl;
using test::Scratch;
using test::slurp;

std::string page() {
    return slurp(test::fs::path(test::source_folder()) / "docs" / "guide" / "figures.md");
}

double mean_green(const Image<Rgb8>& image, std::size_t x0, std::size_t y0, std::size_t x1,
                  std::size_t y1) {
    double sum = 0.0;
    for (std::size_t y = y0; y < y1; ++y)
        for (std::size_t x = x0; x < x1; ++x) sum += image(x, y).g;
    return sum / double((x1 - x0) * (y1 - y0));
}

double mean_green(const Image<Rgb8>& image) {
    return mean_green(image, 0, 0, image.width(), image.height());
}

/// Mean squared difference to the mean.
double variance(const Image<Rgb8>& image, std::size_t x0, std::size_t y0, std::size_t x1,
                std::size_t y1) {
    const double mean = mean_green(image, x0, y0, x1, y1);
    double sum = 0.0;
    for (std::size_t y = y0; y < y1; ++y)
        for (std::size_t x = x0; x < x1; ++x) sum += std::pow(image(x, y).g - mean, 2);
    return sum / double((x1 - x0) * (y1 - y0));
}

/// Mean size of the difference of two pictures' greens, in the rows from `begin` to `end`.
double mean_change(const Image<Rgb8>& a, const Image<Rgb8>& b, std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t y = begin; y < end; ++y)
        for (std::size_t x = 0; x < a.width(); ++x) sum += std::abs(a(x, y).g - b(x, y).g);
    return sum / double((end - begin) * a.width());
}

TEST(Figures, AreSmallAndInTheRepository) {
    const test::fs::path folder = test::fs::path(test::source_folder()) / "docs" / "figures";
    std::set<std::string> names;
    for (const Figure& figure : figures()) {
        EXPECT_TRUE(names.insert(figure.name + ".png").second) << figure.name;
        const test::fs::path file = folder / (figure.name + ".png");
        ASSERT_TRUE(test::fs::exists(file)) << file;
        EXPECT_LE(test::fs::file_size(file), figure_limit) << file;
        const Image<Rgb8> picture = read_png(file.string());
        EXPECT_GE(std::min(picture.width(), picture.height()), 240u);
        EXPECT_EQ(figure.parts.size() % figure.columns, 0u) << figure.name;
    }
    for (const auto& entry : test::fs::directory_iterator(folder))
        EXPECT_EQ(names.count(entry.path().filename()), 1u) << entry.path();
}

TEST(Figures, PageShowsEachWithItsCommands) {
    const std::string text = page();
    for (const Figure& figure : figures()) {
        EXPECT_NE(text.find(fmt::format("](../figures/{}.png)", figure.name)), std::string::npos)
            << figure.name;
        // The first part's command; of many alike the page need not show more.
        const std::string command = figure.has_commands()
                                        ? fmt::format("burl render --direct {} ", figure.parts[0])
                                        : fmt::format("burl figures -o . --only {}\n", figure.name);
        EXPECT_NE(text.find(command), std::string::npos) << figure.parts[0];
    }
}

std::string resized(std::string arguments, const std::string& size) {
    const std::size_t at = arguments.find("--size ") + 7;
    const std::size_t end = std::min(arguments.find(' ', at), arguments.size());
    return arguments.replace(at, end - at, size);
}

TEST(Figures, EveryPartIsACommandWhosePictureIsNotFlatAndTheSameOnAnyThreads) {
    for (const Figure& figure : figures())
        for (const std::string& part : figure.parts) {
            const std::string arguments = figure.has_commands() ? resized(part, "48x40") : part;
            const Image<Rgb8> picture = draw_part(arguments);
            EXPECT_GT(variance(picture, 0, 0, picture.width(), picture.height()), 20.0) << part;
            const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
            EXPECT_EQ(draw_part(arguments), picture) << part;
        }
}

TEST(Figures, ProgramDrawsWhatTheCommandsDo) {
    const Scratch scratch;
    const std::string folder = scratch / "new/figures";
    const test::Outcome made =
        run_burl(scratch, fmt::format("figures -o '{}' --only checkers", folder));
    ASSERT_EQ(made.exit_code, 0) << made.err;
    EXPECT_NE(made.out.find("checkers.png: 728 x 240 pixels"), std::string::npos) << made.out;
    const Image<Rgb8> whole = read_png(folder + "/checkers.png");
    const test::Outcome commands = run_burl(scratch, "figures --only checkers --commands");
    ASSERT_EQ(commands.exit_code, 0) << commands.err;
    for (std::size_t part = 0; part < 3; ++part) {
        // "burl render ... -o checkers-1.png": as a reader would type it, but into our folder.
        const std::string name = fmt::format("checkers-{}.png", part + 1);
        const std::size_t end = commands.out.find(" -o " + name);
        ASSERT_NE(end, std::string::npos) << commands.out;
        const std::size_t at = commands.out.rfind("burl ", end) + 5;
        const std::string line = commands.out.substr(at, end - at);
        ASSERT_EQ(run_burl(scratch, fmt::format("{} -o '{}'", line, scratch / name)).exit_code, 0);
        const Image<Rgb8> alone = read_png(scratch / name);
        for (std::size_t y = 0; y < alone.height(); y += 7)
            for (std::size_t x = 0; x < alone.width(); ++x)
                ASSERT_EQ(whole(244 * part + x, y), alone(x, y)) << part << ' ' << x << ' ' << y;
    }
    EXPECT_EQ(whole(241, 100), (Rgb8{255, 255, 255}));
}

TEST(Figures, ProgramSaysWhatIsWrong) {
    const Scratch scratch;
    const auto code = [&](const std::string& arguments) {
        const test::Outcome outcome = run_burl(scratch, "figures " + arguments);
        if (outcome.exit_code != 0) test::expect_one_sentence(outcome.err);
        return outcome.exit_code;
    };
    EXPECT_EQ(code(""), 1);
    EXPECT_EQ(code(fmt::format("-o '{}' --only teapot", scratch / "a")), 1);
    EXPECT_FALSE(test::fs::exists(scratch / "a"));
    scratch.write("file", "");
    EXPECT_EQ(code(fmt::format("-o '{}' --only fire", scratch / "file")), 2);
    EXPECT_EQ(code(fmt::format("-o '{}' --only fire", scratch / "file/below")), 2);
}

TEST(FigureZonePlate, OuterRingsBecomeTheMapsMean) {
    const Figure figure = find_figure("zone-plate");
    const Image<Rgb8> aliased = draw_part(figure.parts[2]), filtered = draw_part(figure.parts[3]);
    // Towards the corners the filter spans more than the map: half of white light, code 188.
    for (const auto& [x, y] : {std::pair{0u, 0u}, {226u, 0u}, {0u, 226u}, {226u, 226u}}) {
        EXPECT_NEAR(mean_green(filtered, x, y, x + 30, y + 30), 188.0, 2.0);
        EXPECT_LT(variance(filtered, x, y, x + 30, y + 30), 200.0);
        EXPECT_GT(variance(aliased, x, y, x + 30, y + 30), 10000.0);
    }
    // In the middle both show the same rings.
    for (const std::size_t x : {131u, 136u, 144u, 149u})  // black, black, white, black
        EXPECT_EQ(filtered(x, 128).g, aliased(x, 128).g) << x;
    EXPECT_GT(variance(filtered, 100, 100, 156, 156), 8000.0);
}

TEST(FigureNoise, SlopesHaveNoMeanAndStandStillInTheirPlane) {
    const Figure figure = find_figure("noise-derivatives");
    ASSERT_EQ(figure.parts.size(), 24u);
    for (std::size_t i = 6; i < 24; ++i)
        EXPECT_NEAR(mean_green(draw_part(figure.parts[i])), 128.0, 20.0) << figure.parts[i];
    // Classic and improved noise are 0 on the lattice, simplex noise is not.
    const auto corner = [&](std::size_t part) {
        // An odd size has a lattice point, the origin, in the middle of its middle pixel.
        const std::string arguments = resized(figure.parts[part], "101x101");
        return draw_part(arguments + " --supersample 1 --filter none")(50, 50).g;
    };
    EXPECT_EQ(corner(0), 128);
    EXPECT_EQ(corner(2), 128);
    EXPECT_NE(corner(3), 128);
}

TEST(FigurePasses, WeightedCornersAddUpToTheNoise) {
    const std::vector<std::string> parts = find_figure("noise-passes").parts;
    ASSERT_EQ(parts.size(), 16u);
    const auto light = [](const Image<Rgb8>& picture, std::size_t x, std::size_t y) {
        return srgb_decode(double(picture(x, y).g) / 255.0);
    };
    std::vector<Image<Rgb8>> corners;
    for (std::size_t i = 12; i < 16; ++i) corners.push_back(draw_part(parts[i]));
    const Image<Rgb8> noise = draw_part(parts[7]);
    for (std::size_t y = 0; y < noise.height(); ++y)
        for (std::size_t x = 0; x < noise.width(); ++x) {
            double sum = 0.0;
            for (const Image<Rgb8>& corner : corners) sum += light(corner, x, y);
            ASSERT_NEAR(sum, light(noise, x, y), 0.015) << x << ' ' << y;
        }
    EXPECT_GT(variance(noise, 0, 0, noise.width(), noise.height()), 500.0);
}

TEST(FigureChannels, ImageIsMadeOfItsChannels) {
    const std::vector<std::string> parts = find_figure("image-channels").parts;
    ASSERT_EQ(parts.size(), 3u);
    const Image<Rgb8> image = draw_part(parts[0]), s = draw_part(parts[1]), t = draw_part(parts[2]);
    for (std::size_t y = 0; y < image.height(); ++y)
        for (std::size_t x = 0; x < image.width(); ++x) {
            ASSERT_EQ(image(x, y), (Rgb8{s(x, y).r, t(x, y).r, 0}));
            ASSERT_EQ(s(x, y), (Rgb8{s(x, y).r, s(x, y).r, s(x, y).r}));
            // The fraction of a place in 4 x 4 cells of 60 pixels.
            const double place = double(x % 60) / 60.0 + 0.5 / 60.0;
            ASSERT_NEAR(srgb_decode(double(s(x, y).r) / 255.0), place, 0.012) << x << ' ' << y;
        }
}

/// The share of the variance of 16 x 16 squares that is the same along whole rows or columns.
double share_of_lines(const Image<Rgb8>& picture) {
    std::array<double, 16> rows{}, columns{};
    double mean = 0.0, all = 0.0, rest = 0.0;
    const auto at = [&](std::size_t i, std::size_t j) {
        return double(picture(15 * i + 7, 15 * j + 7).g);
    };
    for (std::size_t j = 0; j < 16; ++j)
        for (std::size_t i = 0; i < 16; ++i) {
            rows[j] += at(i, j) / 16.0, columns[i] += at(i, j) / 16.0;
            mean += at(i, j) / 256.0;
        }
    for (std::size_t j = 0; j < 16; ++j)
        for (std::size_t i = 0; i < 16; ++i) {
            all += std::pow(at(i, j) - mean, 2);
            rest += std::pow(at(i, j) - rows[j] - columns[i] + mean, 2);
        }
    return 1.0 - rest / all;
}

TEST(FigureBits, FirstNumbersAreSumsOfRowsAndColumnsAndSecondOnesHardly) {
    const std::vector<std::string> parts = find_figure("blended-bits").parts;
    ASSERT_EQ(parts.size(), 2u);
    const Image<Rgb8> mixed = draw_part(parts[0]), numbers = draw_part(parts[1]);
    // 15 rows and 15 columns of 255 degrees of freedom would be 12 % of white noise.
    EXPECT_GT(share_of_lines(mixed), 0.98);
    EXPECT_LT(share_of_lines(numbers), 0.5);
    EXPECT_GT(variance(numbers, 0, 0, 240, 240), 100.0);
}

TEST(FigureSea, HorizonIsWhereTheViewPutsIt) {
    // 3 degrees below the middle of 180 rows that span 35 degrees.
    const double degree = std::numbers::pi / 180.0;
    const double row = 90.0 * (1.0 + std::tan(3.0 * degree) / std::tan(17.5 * degree));
    const Image<Rgb8> picture = draw_part(resized(find_figure("seascape").parts[0], "240x180"));
    const auto brightness = [&](std::size_t y) { return mean_green(picture, 0, y, 240, y + 1); };
    EXPECT_GT(brightness(std::size_t(row) - 1), 180.0);
    EXPECT_LT(brightness(std::size_t(row) + 1), 120.0);
    // The haze at the horizon is of one colour; overhead there are clouds.
    EXPECT_LT(variance(picture, 0, std::size_t(row) - 2, 240, std::size_t(row)), 30.0);
    EXPECT_GT(variance(picture, 0, 0, 240, 30), 800.0);
}

/// A flight by textures that come towards the camera is one of the camera.
TEST(FigureFlight, MovesTexturesAsACameraWouldMove) {
    const std::string rest = "--size 60x48 --supersample 1 --unlit --filter trapezoid";
    for (const auto& [plane, back] :
         {std::pair("clouds:0,1,0,1", "-0.3"), {"sea:0,1,0,-0.6", "-0.2"}}) {
        const std::string recipe = std::string(plane).substr(0, std::string(plane).find(':'));
        const Image<Rgb8> flown =
            draw_part(fmt::format("--plane {} --view 0,0,3.4 {}", plane, rest));
        const Image<Rgb8> moved =
            draw_part(fmt::format("--plane {} --view 0,0,3.5 {} --set {}:solid.translate.2={}",
                                  plane, rest, recipe, back));
        const Image<Rgb8> still =
            draw_part(fmt::format("--plane {} --view 0,0,3.5 {}", plane, rest));
        EXPECT_GT(mean_change(flown, still, 0, 48), 2.0);
        EXPECT_LT(mean_change(flown, moved, 0, 48), 0.01);
    }
}

TEST(FigureFlight, FlickersLessNearTheHorizonWithTheFilter) {
    const std::vector<std::string> parts = find_figure("seascape-flight").parts;
    ASSERT_EQ(parts.size(), 6u);
    std::vector<Image<Rgb8>> frames;
    for (const std::string& part : parts) frames.push_back(draw_part(part));
    for (const std::size_t i : {0u, 1u}) {
        EXPECT_GT(mean_change(frames[i], frames[i + 1], 95, 105), 15.0);
        EXPECT_LT(mean_change(frames[i + 3], frames[i + 4], 95, 105), 8.0);
        EXPECT_GT(mean_change(frames[i + 3], frames[i + 4], 0, 50), 10.0);  // it does move
    }
}

TEST(FigureTorus, FilterGrowsFromTheRingsCentreOutwards) {
    const Image<Rgb8> widths = draw_part(find_figure("wood-torus").parts[2]);
    const auto mean_at = [&](std::size_t x) { return mean_green(widths, x, 105, x + 10, 115); };
    EXPECT_LT(mean_at(48), 60.0);
    EXPECT_GT(mean_at(242), 200.0);
}

}  // namespace
}  // namespace burl
