// What the options of light mean, and which are refused in a sentence.
#include "app/options/light.h"

#include <gmock/gmock.h>

#include "atlas/base/error.h"

namespace burl {
namespace {

std::string refusal(const LightArguments& arguments) {
    try {
        arguments.light_options();
        arguments.background_asked();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        return error.what();
    }
    return "";
}

TEST(LightArguments, WithoutAnyTheStudioLights) {
    const LightArguments none;
    const LightOptions options = none.light_options();
    EXPECT_EQ(options.light, "studio");
    EXPECT_TRUE(options.tone_curve);
    EXPECT_EQ(options.exposure, 0.0);
    EXPECT_EQ(none.background_asked(), Background{});
    EXPECT_EQ(none.given(), "");
    EXPECT_TRUE(none.files().empty());
}

TEST(LightArguments, SayLightAndBackground) {
    const LightArguments all{.light = "rooms/hall.HDR",
                             .tone = "none",
                             .background = "#0a14ff",
                             .turn = -30.0,
                             .exposure = 1.5};
    EXPECT_EQ(all.light_options(), (LightOptions{"rooms/hall.HDR", -30.0, 1.5, false}));
    EXPECT_EQ(all.background_asked().color, (Rgb8{10, 20, 255}));
    EXPECT_EQ(all.files(), std::vector<std::string>{"rooms/hall.HDR"});
    EXPECT_EQ((LightArguments{.background = "transparent"}).background_asked().kind,
              Background::Kind::transparent);
    EXPECT_EQ((LightArguments{.background = "light"}).background_asked().kind,
              Background::Kind::light);
}

TEST(LightArguments, RefuseWhatMeansNothing) {
    using testing::HasSubstr;
    EXPECT_THAT(refusal({.light = "studoi"}), HasSubstr("did you mean studio?"));
    EXPECT_THAT(refusal({.light = "room.png"}), HasSubstr(".exr or .hdr"));
    for (const char* color : {"", "12345", "1234567", "12345g", "+12345", "red"})
        EXPECT_THAT(refusal({.background = color}), HasSubstr("RRGGBB")) << color;
    EXPECT_THAT(refusal({.light = "headlight", .turn = 3.0}), HasSubstr("--turn-light"));
    EXPECT_THAT(refusal({.light = "headlight", .tone = "none"}), HasSubstr("--tone"));
    EXPECT_THAT(refusal({.light = "headlight", .background = "light"}),
                HasSubstr("--background light"));
    EXPECT_EQ(refusal({.light = "headlight", .exposure = 1.0, .ground = true}), "");
}

TEST(LightArguments, TellWhatIsAboutLight) {
    EXPECT_EQ((LightArguments{.tone = "none"}).given(), "--tone");
    EXPECT_EQ((LightArguments{.exposure = 0.0}).given(), "--exposure");
    EXPECT_EQ((LightArguments{.background = "light"}).given(), "--background light");
    EXPECT_EQ((LightArguments{.background = "ffffff"}).given(), "");
    EXPECT_EQ((LightArguments{.ground = true}).given(), "--ground");
}

}  // namespace
}  // namespace burl
