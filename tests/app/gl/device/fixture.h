#pragma once
// A fixture for tests that draw with OpenGL, which are skipped visibly where OSMesa is not
// installed. BURL_TEST_GL=egl in the environment runs them on a graphics processor instead.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>

#include "app/gl/device/context.h"
#include "atlas/base/error.h"
#include "atlas/base/image.h"

namespace burl {

/// The context of BURL_TEST_GL, a name of gl_platforms(); OSMesa's unless that is set.
inline std::unique_ptr<GlContext> create_test_context() {
    const char* const platform = std::getenv("BURL_TEST_GL");
    return create_gl_context(platform ? std::string(platform) : "osmesa");
}

class GlTest : public testing::Test {
  protected:
    void SetUp() override {
        try {
            context = create_test_context();
        } catch (const Error& error) {
            GTEST_SKIP() << error.what();
        }
    }

    std::unique_ptr<GlContext> context;
};

/// Returns the number of pixels in which two images differ; the images must have the same size and
/// not be empty.
template <class Pixel>
std::size_t differing(const Image<Pixel>& a, const Image<Pixel>& b) {
    EXPECT_FALSE(a.pixels().empty());
    EXPECT_EQ(a.width(), b.width());
    EXPECT_EQ(a.height(), b.height());
    if (a.width() != b.width() || a.height() != b.height())
        return std::max(a.pixels().size(), b.pixels().size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i)
        count += a.pixels()[i] == b.pixels()[i] ? 0 : 1;
    return count;
}

}  // namespace burl
