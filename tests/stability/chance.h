#pragma once
// Random numbers for the stability suite's inputs, identical in every run.
#include <array>
#include <random>

#include "atlas/base/vec.h"

namespace burl {

class Chance {
  public:
    explicit Chance(std::uint32_t seed) : random_(seed) {}
    double signed_unit() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
    Vec3d vector() { return {signed_unit(), signed_unit(), signed_unit()}; }
    std::uint32_t bits() { return std::uint32_t(random_()); }
    template <class T, std::size_t N>
    const T& pick(const std::array<T, N>& all) {
        return all[random_() % N];
    }

  private:
    std::mt19937 random_;
};

}  // namespace burl
