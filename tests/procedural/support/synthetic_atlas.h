#pragma once
// A SolidAtlas made without a mesh or a layout: rectangles of texels with random affine maps.
#include <random>

#include "atlas/solid/solid_atlas.h"

namespace burl {

/// The parameters of a synthetic atlas.
struct SyntheticAtlas {
    std::uint32_t size = 64;   ///< side N of the texture in texels
    std::uint32_t block = 16;  ///< side of a rectangle in texels; the last ones are cut off
    double offset = 0.0;       ///< blocks start within +-1 of (offset, -offset, offset)
    double step = 0.01;        ///< largest component of the step between texels
    bool holes = true;         ///< whether every seventh block has no owner

    SolidAtlas make(std::uint32_t seed) const {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> unit(-1.0, 1.0);
        const auto vector = [&] { return Vec3d{unit(random), unit(random), unit(random)}; };
        const std::uint32_t across = (size + block - 1) / block;
        SolidAtlas solid;
        solid.size = size;
        for (std::uint32_t i = 0; i < across * across; ++i)
            solid.maps.push_back({Vec3d(offset, -offset, offset) + vector(), step * vector(),
                                  step * vector(), std::int32_t(i % across * block),
                                  std::int32_t(i / across * block)});
        for (std::uint32_t y = 0; y < size; ++y) {
            solid.row_begin.push_back(solid.spans.size());
            for (std::uint32_t x = 0; x < size; x += block) {
                const std::uint32_t triangle = y / block * across + x / block;
                if (!holes || triangle % 7 != 3)
                    solid.spans.push_back({x, std::min(block, size - x), triangle});
            }
        }
        solid.row_begin.push_back(solid.spans.size());
        return solid;
    }
};

}  // namespace burl
