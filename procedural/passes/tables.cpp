#include "procedural/passes/tables.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "procedural/numbers/lattice_hash.h"

namespace burl {

namespace {

/// Random bits for entry `i` of table `table`.
std::uint32_t random_bits(std::uint32_t seed, std::uint32_t table, std::uint32_t i) {
    return LatticeHash::bits(i, table, 0x7ab1e5u, seed);
}

/// The luminance, 0..255, of one side of a pair of colours.
float random_luminance(std::uint32_t seed, std::uint32_t pair, std::uint32_t side) {
    return float(LatticeHash::bits(pair, side, 0xb175u, seed) >> 24);
}

BitColors random_colors(std::uint32_t seed, std::uint32_t pair) {
    return {{random_luminance(seed, pair, 0), random_luminance(seed, pair, 1)}};
}

/// Blends one of the colours over `under`, chosen by the highest of eight bits.
std::uint32_t blended_by(std::uint32_t bits, const BitColors& colors, std::uint32_t under) {
    return blended(under, std::uint32_t(colors.luminance[bits >> 7 & 1]));
}

}  // namespace

RandomTables random_tables(std::uint32_t seed) {
    RandomTables tables;
    for (std::uint32_t table = 0; table < 3; ++table)
        for (std::uint32_t i = 0; i < pass_table_size; ++i)
            tables[table][i] = float((random_bits(seed, table, i) >> 16) * 86 >> 16);
    std::array<std::uint32_t, pass_table_size> order;
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return random_bits(seed, 3, i); });
    for (std::size_t i = 0; i < pass_table_size; ++i)
        tables[3][i] = (float(2 * order[i]) - 255.0f) * 0x1p-8f;
    return tables;
}

std::uint32_t BitRandomizer::mixed(const std::array<std::uint32_t, 3>& point) const {
    auto blend = std::uint32_t(blend_start);
    for (unsigned bit = 0; bit < bits; ++bit)
        for (unsigned axis = 0; axis < 3; ++axis)
            blend = blended_by(point[axis] << (8 - bits + bit), coordinates[3 * bit + axis], blend);
    return blend;
}

std::uint32_t BitRandomizer::operator()(const std::array<std::uint32_t, 3>& point) const {
    const std::uint32_t first = mixed(point);
    auto number = std::uint32_t(blend_start);
    for (unsigned bit = 0; bit < 8; ++bit) number = blended_by(first << bit, result[bit], number);
    return number;
}

BitRandomizer bit_randomizer(std::uint32_t seed, unsigned bits) {
    BitRandomizer randomizer;
    randomizer.bits = bits;
    for (std::uint32_t pair = 0; pair < 3 * bits; ++pair)
        randomizer.coordinates.push_back(random_colors(seed, pair));
    for (std::uint32_t pair = 0; pair < 8; ++pair)
        randomizer.result[pair] = random_colors(seed, 0x100 + pair);
    return randomizer;
}

std::array<float, pass_table_size> equal_table(const BitRandomizer& randomizer) {
    std::array<double, pass_table_size> histogram{};
    const std::uint32_t n = 1u << randomizer.bits;
    for (std::uint32_t z = 0; z < n; ++z)
        for (std::uint32_t y = 0; y < n; ++y)
            for (std::uint32_t x = 0; x < n; ++x) ++histogram[randomizer({x, y, z})];
    std::array<float, pass_table_size> table{};
    double below = 0.0;
    const double points = double(n) * double(n) * double(n);
    for (std::size_t i = 0; i < pass_table_size; ++i) {
        table[i] = float(std::floor(255.0 * (below + 0.5 * histogram[i]) / points + 0.5));
        below += histogram[i];
    }
    return table;
}

}  // namespace burl
