#pragma once
// Tests that draw with OpenGL: skipped, visibly, where OSMesa is not installed.
#include <gtest/gtest.h>

#include <memory>

#include "app/gl_context.h"
#include "atlas/error.h"

namespace burl {

class GlTest : public testing::Test {
  protected:
    void SetUp() override {
        try {
            context = create_osmesa_context();
        } catch (const Error& error) {
            GTEST_SKIP() << error.what();
        }
    }

    std::unique_ptr<GlContext> context;
};

}  // namespace burl
