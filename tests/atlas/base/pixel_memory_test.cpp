// Memory of images: aligned, as large as asked for, set only where a value is given.
#include "atlas/base/memory.h"

#include <cstdint>
#include <cstring>
#include <limits>
#include <new>

#include <gtest/gtest.h>

#include "atlas/base/image.h"

namespace burl {
namespace {

TEST(PixelMemory, IsAlignedAndWhole) {
    for (const std::size_t bytes : {std::size_t(0), std::size_t(1), std::size_t(1000),
                                    std::size_t(1) << 20, (std::size_t(9) << 20) + 7}) {
        void* pixels = allocate_pixels(bytes);
        EXPECT_EQ(std::uintptr_t(pixels) % 64, 0u);
        std::memset(pixels, 0x5a, bytes);
        free_pixels(pixels);
    }
}

TEST(PixelMemory, RefusesWhatNoMachineHas) {
    EXPECT_THROW(free_pixels(allocate_pixels(std::numeric_limits<std::size_t>::max())),
                 std::bad_alloc);
    EXPECT_THROW(free_pixels(allocate_pixels(std::numeric_limits<std::size_t>::max() / 2)),
                 std::bad_alloc);
}

TEST(PixelMemory, ImagesKeepTheirValues) {
    const Image<Rgb8> filled(2000, 1000, Rgb8{1, 2, 3});  // in huge pages, where there are any
    EXPECT_EQ(filled(0, 0), (Rgb8{1, 2, 3}));
    EXPECT_EQ(filled(1999, 999), (Rgb8{1, 2, 3}));
    Image<Rgb8> unset = Image<Rgb8>::unset(2000, 1000);
    EXPECT_EQ(unset.pixels().size(), 2000000u);
    for (std::size_t y = 0; y < 1000; ++y)
        for (Rgb8& pixel : unset.row(y)) pixel = {1, 2, 3};
    EXPECT_EQ(unset, filled);
    const Image<Rgb8> copy = unset;
    EXPECT_EQ(copy, filled);
    EXPECT_EQ((Image<float>(3, 2)(2, 1)), 0.0f);
}

}  // namespace
}  // namespace burl
