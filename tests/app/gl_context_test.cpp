#include "app/gl_context.h"

#include <glad/gl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "app/gl_objects.h"
#include "tests/app/gl_fixture.h"

namespace burl {
namespace {

using testing::HasSubstr;

TEST(GlContext, MissingLibraryNamesThePackage) {
    const std::array names{"libNoSuchMesa.so.8", "libNoSuchMesa.so"};
    try {
        create_osmesa_context(names);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::unsupported);
        EXPECT_THAT(error.what(), HasSubstr("libosmesa6"));
    }
}

TEST(GlContext, LibraryWithoutTheFunctionsIsTooOld) {
    const std::array names{"libm.so.6"};
    try {
        create_osmesa_context(names);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::unsupported);
        EXPECT_THAT(error.what(), HasSubstr("libm.so.6"));
        EXPECT_THAT(error.what(), HasSubstr("libosmesa6"));
    }
}

using GlContextTest = GlTest;

TEST_F(GlContextTest, GivesCoreFunctions) {
    GLint major = 0, minor = 0, profile = 0;
    context->gl().GetIntegerv(GL_MAJOR_VERSION, &major);
    context->gl().GetIntegerv(GL_MINOR_VERSION, &minor);
    context->gl().GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_GE(10 * major + minor, 33);
    EXPECT_EQ(profile & GL_CONTEXT_CORE_PROFILE_BIT, GL_CONTEXT_CORE_PROFILE_BIT);
    EXPECT_THAT(context->description(), HasSubstr("OSMesa"));
}

TEST_F(GlContextTest, ContextsAreIndependent) {
    const auto other = create_osmesa_context();
    other->gl().ClearColor(0.25f, 0, 0, 0);
    context->make_current();
    std::array<float, 4> color{};
    context->gl().GetFloatv(GL_COLOR_CLEAR_VALUE, color.data());
    EXPECT_EQ(color[0], 0.0f);
    other->make_current();
    other->gl().GetFloatv(GL_COLOR_CLEAR_VALUE, color.data());
    EXPECT_EQ(color[0], 0.25f);
}

TEST_F(GlContextTest, ErrorsNameTheActionOnce) {
    context->gl().Enable(0xffff);
    try {
        check_gl(context->gl(), "testing");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::runtime);
        EXPECT_THAT(error.what(), HasSubstr("testing"));
        EXPECT_THAT(error.what(), HasSubstr("invalid enum"));
    }
    EXPECT_NO_THROW(check_gl(context->gl(), "testing"));
}

TEST_F(GlContextTest, ShaderErrorsCarryTheLog) {
    const char* vertex = "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n";
    const char* broken = "#version 330 core\nvoid main() { no_such_name = 1.0; }\n";
    try {
        GlProgram::from_source(context->gl(), "broken", vertex, broken);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::runtime);
        EXPECT_THAT(error.what(), HasSubstr("fragment shader of broken"));
        EXPECT_THAT(error.what(), HasSubstr("no_such_name"));
    }
    EXPECT_NO_THROW(check_gl(context->gl(), "cleaning up"));
}

TEST_F(GlContextTest, FramebufferTooLargeIsAnError) {
    EXPECT_THROW(GlFramebuffer(context->gl(), 1 << 20, 4), Error);
    EXPECT_NO_THROW(GlFramebuffer(context->gl(), 16, 4));
}

}  // namespace
}  // namespace burl
