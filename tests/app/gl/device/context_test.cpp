#include "app/gl/device/context.h"

#include <glad/gl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string_view>

#include "app/gl/device/objects.h"
#include "app/gl/device/target.h"
#include "tests/app/gl/device/fixture.h"

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

TEST(GlContext, MissingEglNamesThePackage) {
    const std::array names{"libNoSuchEgl.so.1", "libNoSuchEgl.so"};
    try {
        create_egl_context(names);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::unsupported);
        EXPECT_THAT(error.what(), HasSubstr("libegl1"));
    }
}

TEST(GlContext, LibraryThatIsNoEglIsRefused) {
    const std::array names{"libm.so.6"};
    try {
        create_egl_context(names);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::unsupported);
        EXPECT_THAT(error.what(), HasSubstr("libm.so.6"));
        EXPECT_THAT(error.what(), HasSubstr("libegl1"));
    }
}

TEST(GlContext, UnknownPlatformsAreUsageErrors) {
    try {
        create_gl_context("metal");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        EXPECT_THAT(error.what(), HasSubstr("--gl metal"));
    }
}

/// A driver that tells a version and has no other function.
class OldContext final : public GlContext {
  public:
    OldContext() { load_functions("libOld.so"); }
    void make_current() override {}
    void release() override {}
    std::unique_ptr<GlContext> share() override { return nullptr; }
    std::string origin() const override { return "old"; }
    GlProcedure get_proc(const char* name) override {
        if (std::string_view(name) != "glGetString") return nullptr;
        return reinterpret_cast<GlProcedure>(&version);
    }

  private:
    static const GLubyte* version(GLenum) { return reinterpret_cast<const GLubyte*>("2.1 Old"); }
};

TEST(GlContext, TooLowAVersionIsUnsupported) {
    try {
        OldContext();
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::unsupported);
        EXPECT_THAT(error.what(), HasSubstr("libOld.so gives OpenGL 2.1"));
        EXPECT_THAT(error.what(), HasSubstr("3.3"));
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
    auto other = create_osmesa_context();
    other->gl().ClearColor(0.25f, 0, 0, 0);
    context->make_current();
    std::array<float, 4> color{};
    context->gl().GetFloatv(GL_COLOR_CLEAR_VALUE, color.data());
    EXPECT_EQ(color[0], 0.0f);
    other->make_current();
    other->gl().GetFloatv(GL_COLOR_CLEAR_VALUE, color.data());
    EXPECT_EQ(color[0], 0.25f);
    // The end of one does not take the current one away.
    context->make_current();
    other.reset();
    context->gl().ClearColor(0.5f, 0, 0, 0);
    context->gl().GetFloatv(GL_COLOR_CLEAR_VALUE, color.data());
    EXPECT_EQ(color[0], 0.5f);
}

/// Clears one texel and reads it back.
float cleared_texel(GlContext& context, float value) {
    context.make_current();
    const GlTarget target(context.gl(), {1, 1}, {GL_R32F});
    target.clear(0, Vec4f(value));
    return target.read<float>()[0];
}

TEST_F(GlContextTest, EglDrawsBesideOsMesa) {
    std::unique_ptr<GlContext> egl;
    try {
        egl = create_gl_context("egl");
    } catch (const Error& error) {
        GTEST_SKIP() << error.what();
    }
    EXPECT_THAT(egl->description(), HasSubstr("EGL"));
    GLint profile = 0;
    egl->gl().GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_EQ(profile & GL_CONTEXT_CORE_PROFILE_BIT, GL_CONTEXT_CORE_PROFILE_BIT);
    for (const float value : {0.5f, -3.0f}) {
        EXPECT_EQ(cleared_texel(*egl, value), value);
        EXPECT_EQ(cleared_texel(*context, 2.0f * value), 2.0f * value);
    }
    const auto other = create_gl_context("egl");
    egl.reset();
    EXPECT_EQ(cleared_texel(*other, 7.0f), 7.0f);
}

TEST_F(GlContextTest, FactsAreThoseOfTheContext) {
    std::map<std::string, std::string> facts;
    for (const GlFact& fact : gl_facts(*context)) facts[fact.name] = fact.value;
    EXPECT_EQ(facts["context"], "OSMesa");
    EXPECT_THAT(facts["version"], HasSubstr("Mesa"));
    GLint size = 0;
    context->gl().GetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
    EXPECT_EQ(facts["largest texture"], fmt::format("{} texels a side", size));
    EXPECT_EQ(facts["float64 in shaders"], has_float64(context->gl()) ? "yes" : "no");
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
        GlProgram(context->gl(), "broken", ShaderSource().add("vertex", vertex),
                  ShaderSource().add("broken", broken));
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
