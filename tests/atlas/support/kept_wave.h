#pragma once
// The share of a wave that a truncated round Gaussian keeps, summed over a fine grid.
#include <cmath>

namespace burl::made {

/// Returns the share of cos(k x) kept at x = 0 by exp(-r^2 / 2) within r <= cut; k is in radians
/// per standard deviation.
inline double kept_by_gaussian(double k, double cut) {
    double kept = 0.0, total = 0.0;
    for (double x = -cut + 0.01; x < cut; x += 0.02)
        for (double y = -cut + 0.01; y < cut; y += 0.02) {
            const double r = x * x + y * y;
            if (r > cut * cut) continue;
            kept += std::exp(-0.5 * r) * std::cos(k * x);
            total += std::exp(-0.5 * r);
        }
    return kept / total;
}

}  // namespace burl::made
