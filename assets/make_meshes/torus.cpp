// A torus: genus 1, and an area known in closed form, 4 pi^2 R r.
#include <cmath>
#include <numbers>

#include "assets/make_meshes/model.h"

namespace burl {

Model make_torus(int around, int across) {
    constexpr double large = 1.0, small = 0.4;
    const auto at = [&](int i, int j) {
        const double u = 2.0 * std::numbers::pi * (i % around) / around;
        const double v = 2.0 * std::numbers::pi * (j % across) / across;
        const double distance = large + small * std::cos(v);
        return Vec3d(distance * std::cos(u), small * std::sin(v), -distance * std::sin(u));
    };
    Model model;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j)
            model.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    return model;
}

}  // namespace burl
