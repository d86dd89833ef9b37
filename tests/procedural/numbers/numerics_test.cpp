// The tables of docs/reference/numerics.md, which a second implementation is written against: every
// row is read from the page and compared, in float64 and within the stated errors in float32.
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "procedural/noise/names.h"
#include "procedural/noise/noise.h"
#include "procedural/noise/perlin_noise.h"
#include "procedural/noise/value_noise.h"
#include "procedural/numbers/lattice_hash.h"
#include "tests/paths.h"

namespace burl {
namespace {

using Row = std::vector<std::string>;

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);)
        if (!part.empty()) parts.push_back(part);
    return parts;
}

std::string trimmed(const std::string& text) {
    const std::size_t from = text.find_first_not_of(" `"), to = text.find_last_not_of(" `");
    return from == std::string::npos ? "" : text.substr(from, to - from + 1);
}

/// The rows of the tables whose first two columns have these names.
std::vector<Row> table(const std::string& first, const std::string& second) {
    std::ifstream page(test::source_folder() + "/docs/reference/numerics.md");
    EXPECT_TRUE(page);
    std::vector<Row> rows;
    bool inside = false;
    for (std::string line; std::getline(page, line);) {
        Row cells;
        for (const std::string& cell : split(line, '|')) cells.push_back(trimmed(cell));
        if (!line.starts_with('|'))
            inside = false;
        else if (cells.at(0) == first && cells.at(1) == second)
            inside = true;
        else if (inside && cells.at(0) != "---")
            rows.push_back(cells);
    }
    return rows;
}

std::vector<double> numbers(const std::string& cell) {
    std::vector<double> result;
    for (const std::string& word : split(cell, ' ')) result.push_back(std::stod(word));
    return result;
}

/// An integer as the page writes it, negative ones modulo 2^32.
std::uint32_t integer(double x) {
    return std::uint32_t(std::int64_t(x));
}

TEST(NumericsPage, GivesTheHashOfLatticePoints) {
    const std::vector<Row> rows = table("index", "seed");
    EXPECT_GE(rows.size(), 12u);
    for (const Row& row : rows) {
        std::array<std::uint32_t, 4> index{};
        std::size_t axis = 0;
        for (const double i : numbers(row.at(0))) index.at(axis++) = integer(i);
        const std::uint32_t seed = integer(std::stod(row.at(1)));
        EXPECT_EQ(LatticeHash::bits(index, seed), std::stoul(row.at(2), nullptr, 16)) << row[0];
        EXPECT_NEAR(lattice_value(index, seed), std::stod(row.at(3)), 1e-8) << row[0];
        EXPECT_EQ(lattice_value(index, seed) * 0x1p23, std::stod(row.at(4))) << row[0];
    }
}

TEST(NumericsPage, GivesTheShiftsOfSeeds) {
    const std::vector<Row> rows = table("seed", "shift along x, y, z, w");
    EXPECT_GE(rows.size(), 4u);
    for (const Row& row : rows)
        for (std::size_t axis = 0; axis < 4; ++axis)
            EXPECT_EQ(LatticeHash::shift(integer(std::stod(row.at(0))), axis),
                      numbers(row.at(1)).at(axis))
                << row[0];
}

TEST(NumericsPage, GivesTheGradientsOfPerlinNoise) {
    std::uint32_t number = 0;
    for (const auto& [first, second] : {std::pair("0", "1"), std::pair("8", "9")})
        for (const Row& row : table(first, second))
            for (const std::string& cell : row) {
                const auto g = perlin_gradient<double, 3>(number++);
                EXPECT_EQ(numbers(cell), std::vector(g.begin(), g.end())) << number - 1;
            }
    EXPECT_EQ(number, 16u);
}

template <class T, std::size_t N>
void set_named(const std::array<Named<T>, N>& names, const std::string& word, T& target) {
    for (const Named<T>& one : names)
        if (one.name == word) target = one.value;
}

NoiseSpec noise_of(const Row& row) {
    NoiseSpec noise;
    const std::vector<std::string> words = split(row.at(0), ' ');
    set_named(noise_kinds, words.at(0), noise.kind);
    if (noise.kind == NoiseKind::value) set_named(fade_names, words.at(1), noise.fade);
    if (noise.kind == NoiseKind::worley) set_named(feature_names, words.at(1), noise.feature);
    if (noise.kind == NoiseKind::simplex && words.size() > 1) noise.radius2 = std::stod(words[1]);
    noise.seed = integer(std::stod(row.at(1)));
    std::size_t axis = 0;
    if (row.at(2) != "-")
        for (const double cells : numbers(row[2])) noise.period.at(axis++) = integer(cells);
    return noise;
}

template <std::size_t N>
void expect_row(const Row& row) {
    const NoiseSpec noise = noise_of(row);
    Point<N> p;
    const std::vector<double> point = numbers(row.at(3)), gradient = numbers(row.at(5));
    ASSERT_EQ(point.size(), N);
    ASSERT_EQ(gradient.size(), N);
    std::copy(point.begin(), point.end(), p.begin());
    const auto exact = sample_noise<double>(noise, p);
    const auto rounded = sample_noise<float>(noise, p);
    const double value = std::stod(row.at(4));
    EXPECT_NEAR(exact.value, value, 1e-13) << row[0] << " at " << row[3];
    EXPECT_NEAR(rounded.value, value, 1.5e-6) << row[0] << " at " << row[3];
    for (std::size_t axis = 0; axis < N; ++axis) {
        EXPECT_NEAR(exact.gradient[axis], gradient[axis], 1e-12) << row[0] << " at " << row[3];
        EXPECT_NEAR(rounded.gradient[axis], gradient[axis], 1e-5) << row[0] << " at " << row[3];
    }
}

TEST(NumericsPage, GivesEveryNoiseOfTheHash) {
    const std::vector<Row> rows = table("noise", "seed");
    EXPECT_GE(rows.size(), 24u);
    for (const Row& row : rows) {
        const std::size_t dimensions = numbers(row.at(3)).size();
        if (dimensions == 1) expect_row<1>(row);
        if (dimensions == 2) expect_row<2>(row);
        if (dimensions == 3) expect_row<3>(row);
        if (dimensions == 4) expect_row<4>(row);
    }
}

}  // namespace
}  // namespace burl
