// Whether the numbers at lattice points pass for random: no repeated patterns, no correlation at
// any small lag, a flat spectrum, balanced bits. Limits are 5 standard deviations, or what chance
// exceeds once in two million trials; a hash without its mixer shows that the measures can fail.
#include "procedural/numbers/lattice_hash.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "procedural/noise/value_noise.h"

namespace burl {
namespace {

constexpr std::array seeds{0u, 1u, 12345u, 4000000000u};

/// The values of `number(i, j, k)` over a cube about the origin, i fastest.
template <class Number>
auto block(std::uint32_t size, Number&& number) {
    std::vector<decltype(number(0u, 0u, 0u))> values;
    values.reserve(std::size_t(size) * size * size);
    for (std::uint32_t k = 0; k < size; ++k)
        for (std::uint32_t j = 0; j < size; ++j)
            for (std::uint32_t i = 0; i < size; ++i)
                values.push_back(number(i - size / 2, j - size / 2, k - size / 2));
    return values;
}

std::vector<double> value_block(std::uint32_t size, std::uint32_t seed) {
    return block(size, [seed](auto i, auto j, auto k) { return lattice_value(i, j, k, seed); });
}

std::vector<double> unmixed_block(std::uint32_t size) {
    return block(size, [](auto i, auto j, auto k) {
        const std::uint32_t sum =
            i * LatticeHash::prime_x + j * LatticeHash::prime_y + k * LatticeHash::prime_z;
        return 0x1p-31 * double(std::int32_t(sum));
    });
}

bool all_different(auto values) {
    std::sort(values.begin(), values.end());
    return std::adjacent_find(values.begin(), values.end()) == values.end();
}

TEST(LatticeHash, ShowsNoPatternTwice) {
    // The smallest patterns: two neighbours' 24-bit values. Larger ones contain these.
    constexpr std::uint32_t size = 96;
    constexpr std::array<std::size_t, 3> next{1, size, size * size};
    for (const std::uint32_t seed : seeds) {
        const auto values = block(size, [seed](auto i, auto j, auto k) {
            return std::uint64_t(LatticeHash::bits(i, j, k, seed) >> 8);
        });
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::vector<std::uint64_t> pairs;
            for (std::size_t p = 0; p < values.size(); ++p)
                if (p / next[axis] % size + 1 < size)
                    pairs.push_back(values[p] << 24 | values[p + next[axis]]);
            EXPECT_EQ(pairs.size(), 96u * 96 * 95);
            EXPECT_TRUE(all_different(pairs)) << "seed " << seed << " axis " << axis;
        }
    }
}

TEST(LatticeHash, GivesNoPointOfAnyOctaveTheBitsOfAnother) {
    // Seeds move one and the same sequence, so octaves could be shifted copies of each other.
    for (const std::uint32_t seed : {0u, 7u}) {
        std::vector<std::uint32_t> bits;
        for (std::uint32_t octave = 0; octave < 24; ++octave) {
            const auto more = block(40, [&](auto i, auto j, auto k) {
                return LatticeHash::bits(i, j, k, seed + octave);
            });
            bits.insert(bits.end(), more.begin(), more.end());
        }
        EXPECT_TRUE(all_different(std::move(bits)));
    }
}

/// The solution x of a x = 1 modulo 2^32, a odd.
std::uint32_t inverse(std::uint32_t a) {
    std::uint32_t x = a;
    for (int i = 0; i < 5; ++i) x *= 2 - a * x;
    return x;
}

/// Largest coordinate of the shortest way (by that measure) from a point of N coordinates, all of
/// at most `reach`, to one that has the same bits with `later` added to the seed.
template <std::size_t N>
int nearest_repeat(std::uint32_t later, int reach) {
    constexpr std::array primes{LatticeHash::prime_x, LatticeHash::prime_y, LatticeHash::prime_z,
                                LatticeHash::prime_w};
    const std::uint32_t last = inverse(primes[N - 1]);
    int nearest = reach + 1;
    const auto look = [&](auto& self, std::size_t axis, std::uint32_t sum, int size) -> void {
        if (axis == N - 1) {
            const auto step = std::int32_t((later * LatticeHash::prime_seed - sum) * last);
            if (std::abs(std::int64_t(step)) > reach) return;
            size = std::max(size, std::abs(step));
            if (size > 0) nearest = std::min(nearest, size);
            return;
        }
        for (int i = -reach; i <= reach; ++i)
            self(self, axis + 1, sum + std::uint32_t(i) * primes[axis],
                 std::max(size, std::abs(i)));
    };
    look(look, 0, 0, 0);
    return nearest;
}

TEST(LatticeHash, RepeatsOnlyAsFarAwayAsStated) {
    // docs/reference/numerics.md states these: the hash depends on a linear sum, so it repeats
    // along a vector.
    EXPECT_EQ(nearest_repeat<2>(0, 30000), 26149);
    EXPECT_EQ(nearest_repeat<3>(0, 1200), 1146);
    EXPECT_EQ(nearest_repeat<4>(0, 170), 165);
    for (const std::uint32_t seed : {0u, 77u}) {
        const std::array here{5u, 6u, 7u}, there{here[0] - 1039, here[1] + 243, here[2] - 1146};
        EXPECT_EQ(LatticeHash::bits(here, seed), LatticeHash::bits(there, seed));
    }
    int nearest = 1000;
    for (std::uint32_t later = 1; later < 24; ++later)
        nearest = std::min(nearest, nearest_repeat<3>(later, 400));
    EXPECT_EQ(nearest, 319);
}

TEST(LatticeHash, GivesUniformValues) {
    for (const std::uint32_t seed : seeds) {
        std::array<int, 64> histogram{};
        for (const double v : value_block(64, seed)) {
            ASSERT_TRUE(v >= -1.0 && v < 1.0);
            ++histogram[std::size_t((v + 1.0) * 32.0)];
        }
        constexpr double expected = 64.0 * 64 * 64 / 64;
        double chi_squared = 0.0;
        for (const int n : histogram) chi_squared += (n - expected) * (n - expected) / expected;
        // 63 degrees of freedom: mean 63, standard deviation 11.2.
        EXPECT_LT(chi_squared, 63 + 5 * 11.2);
    }
}

/// Correlation of a block with itself moved by a lag, in standard deviations of independent values.
double lag_correlation(const std::vector<double>& values, int size, const std::array<int, 3>& lag) {
    const auto range = [&](int axis) {
        return std::pair(std::max(0, -lag[axis]), std::min(size, size - lag[axis]));
    };
    const std::ptrdiff_t step = lag[0] + std::ptrdiff_t(size) * (lag[1] + size * lag[2]);
    const auto [i0, i1] = range(0);
    const auto [j0, j1] = range(1);
    const auto [k0, k1] = range(2);
    double sum = 0.0;
    for (int k = k0; k < k1; ++k)
        for (int j = j0; j < j1; ++j) {
            const double* row = values.data() + std::ptrdiff_t(size) * (j + size * k);
            for (int i = i0; i < i1; ++i) sum += row[i] * row[i + step];
        }
    const double count = double(i1 - i0) * (j1 - j0) * (k1 - k0);
    return 3.0 * sum / std::sqrt(count);  // of variance 1/3 each
}

/// The largest over all lags of up to 3 cells per axis, and up to 40 along each axis.
double largest_correlation(const std::vector<double>& values, int size) {
    double largest = 0.0;
    const auto look = [&](const std::array<int, 3>& lag) {
        largest = std::max(largest, std::abs(lag_correlation(values, size, lag)));
    };
    for (int code = 172; code < 343; ++code)  // half of 7^3: the others mirror them
        look({code % 7 - 3, code / 7 % 7 - 3, code / 49 - 3});
    for (int lag = 4; lag <= 40; ++lag) look({lag, 0, 0}), look({0, lag, 0}), look({0, 0, lag});
    return largest;
}

TEST(LatticeHash, HasNoCorrelationAtAnyLag) {
    for (const std::uint32_t seed : seeds)
        EXPECT_LT(largest_correlation(value_block(64, seed), 64), 5.0) << seed;
    EXPECT_GT(largest_correlation(unmixed_block(64), 64), 50.0);
}

TEST(LatticeHash, HasNoCorrelationBetweenSeeds) {
    const std::vector<double> first = value_block(64, 0);
    for (std::uint32_t seed = 1; seed < 24; ++seed) {
        const std::vector<double> other = value_block(64, seed);
        const double sum = std::inner_product(first.begin(), first.end(), other.begin(), 0.0);
        EXPECT_LT(std::abs(3.0 * sum / 512.0), 5.0) << seed;
    }
}

TEST(LatticeHash, HasBalancedBitsThatNeighboursDoNotShare) {
    constexpr std::size_t size = 64;
    constexpr double count = size * size * size;
    for (const std::uint32_t seed : seeds) {
        const auto bits = block(
            size, [seed](auto i, auto j, auto k) { return LatticeHash::bits(i, j, k, seed); });
        for (unsigned bit = 8; bit < 32; ++bit)
            for (const std::size_t step : {std::size_t(0), std::size_t(1), size, size * size}) {
                int ones = 0;  // of the bit itself, or of its difference to a neighbour's
                for (std::size_t p = 0; p < bits.size(); ++p)
                    ones += (bits[p] ^ (step ? bits[(p + step) % bits.size()] : 0u)) >> bit & 1;
                EXPECT_LT(std::abs(ones - count / 2), 5.0 * std::sqrt(count) / 2) << bit;
            }
    }
}

using Complex = std::complex<double>;

/// In place, for a power of two.
void fourier(std::vector<Complex>& x) {
    const std::size_t half = x.size() / 2;
    if (half == 0) return;
    std::vector<Complex> even(half), odd(half);
    for (std::size_t i = 0; i < half; ++i) even[i] = x[2 * i], odd[i] = x[2 * i + 1];
    fourier(even), fourier(odd);
    for (std::size_t i = 0; i < half; ++i) {
        const Complex turned = std::polar(1.0, -std::numbers::pi * double(i) / double(half));
        x[i] = even[i] + turned * odd[i], x[i + half] = even[i] - turned * odd[i];
    }
}

/// |DFT|^2 of a cube over what independent values of variance 1/3 have on average: 1.
std::vector<double> power_spectrum(const std::vector<double>& values, std::size_t size) {
    std::vector<Complex> cube(values.begin(), values.end()), line(size);
    for (const std::size_t step : {std::size_t(1), size, size * size})
        for (std::size_t p = 0; p < cube.size(); ++p) {
            if (p / step % size != 0) continue;
            for (std::size_t i = 0; i < size; ++i) line[i] = cube[p + i * step];
            fourier(line);
            for (std::size_t i = 0; i < size; ++i) cube[p + i * step] = line[i];
        }
    std::vector<double> power;
    for (const Complex& c : cube) power.push_back(3.0 * std::norm(c) / double(values.size()));
    return power;
}

struct SpectrumFlatness {
    double peak = 0.0;   ///< the largest bin
    double shell = 0.0;  ///< the largest deviation of a shell's mean from 1, in standard deviations
};

SpectrumFlatness spectrum_flatness(const std::vector<double>& values, std::size_t size) {
    const std::vector<double> power = power_spectrum(values, size);
    std::vector<double> sum(2 * size), count(2 * size);
    for (std::size_t p = 0; p < power.size(); ++p) {
        double square = 0.0;
        for (std::size_t step = 1; step < power.size(); step *= size) {
            const std::size_t f = p / step % size;
            square += std::pow(double(std::min(f, size - f)), 2);
        }
        const auto shell = std::size_t(std::lround(std::sqrt(square)));
        sum[shell] += power[p], count[shell] += 1.0;
    }
    SpectrumFlatness flatness{*std::max_element(power.begin(), power.end())};
    // Bins come in equal pairs of exponentially distributed values: deviation sqrt(2 / count).
    for (std::size_t s = 0; s < count.size(); ++s)
        if (count[s] > 0)
            flatness.shell = std::max(
                flatness.shell, std::abs(sum[s] / count[s] - 1.0) / std::sqrt(2.0 / count[s]));
    return flatness;
}

TEST(LatticeHash, HasAFlatSpectrum) {
    for (const std::uint32_t seed : {0u, 12345u}) {
        const SpectrumFlatness flatness = spectrum_flatness(value_block(64, seed), 64);
        // Of 131072 independent bins one exceeds 26.5 once in 2.5 million trials.
        EXPECT_LT(flatness.peak, 26.5) << seed;
        EXPECT_GT(flatness.peak, 8.0) << seed;
        EXPECT_LT(flatness.shell, 5.0) << seed;
    }
    EXPECT_GT(spectrum_flatness(unmixed_block(32), 32).peak, 1000.0);
}

}  // namespace
}  // namespace burl
