// Fonts: what is found, what stands in where nothing is, and characters that come with somebody's
// file names.
#include "app/editor/widgets/fonts.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include "app/base/atomic_file.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

class Fonts : public testing::Test {
  protected:
    const ScratchFolder folder;
    ImFontAtlas atlas;

    bool has(ImWchar code) { return atlas.Fonts[0]->FindGlyphNoFallback(code) != nullptr; }
    std::string file(const std::string& path, const std::string& content) const {
        std::filesystem::create_directories(std::filesystem::path(folder / path).parent_path());
        write_file(folder / path, content);
        return folder / path;
    }
};

TEST_F(Fonts, AreFoundByPurposeTheBestFirst) {
    EXPECT_EQ(find_fonts(folder.path()).text, "");
    const std::string root = "usr/share/fonts/";
    const std::string fallback = file(root + "truetype/dejavu/DejaVuSans.ttf", "x");
    EXPECT_EQ(std::filesystem::path(find_fonts(folder.path()).text), fallback);
    const std::string inter = file(root + "opentype/inter/Inter-Regular.otf", "x");
    EXPECT_EQ(std::filesystem::path(find_fonts(folder.path()).text), inter);
    EXPECT_EQ(std::filesystem::path(find_fonts(folder.path()).symbols), fallback);
    EXPECT_EQ(find_fonts(folder.path()).icons, "");
}

TEST_F(Fonts, WithoutAnyTheBuiltInOneStandsIn) {
    InterfaceFonts fonts({});
    fonts.load(atlas, 17.0f);
    ASSERT_EQ(atlas.Fonts.Size, 1);
    EXPECT_TRUE(has('a'));
    EXPECT_NE(fonts.problem().find("fonts-inter"), std::string::npos) << fonts.problem();
    unsigned char* texels = nullptr;
    int width = 0, height = 0;
    atlas.GetTexDataAsRGBA32(&texels, &width, &height);
    EXPECT_TRUE(texels != nullptr && width > 0 && height > 0);
}

TEST_F(Fonts, AFileThatIsNoFontIsNamed) {
    FontFiles files;
    files.text = file("broken.otf", "this is no font");
    InterfaceFonts fonts(files);
    fonts.load(atlas, 17.0f);
    EXPECT_NE(fonts.problem().find("broken.otf"), std::string::npos) << fonts.problem();
    EXPECT_TRUE(has('a'));
    files.text = folder / "missing.otf";
    InterfaceFonts missing(files);
    missing.load(atlas, 17.0f);
    EXPECT_NE(missing.problem().find("missing.otf"), std::string::npos) << missing.problem();
    EXPECT_TRUE(has('a'));
}

TEST_F(Fonts, HaveAllOfLatinGreekAndCyrillic) {
    const FontFiles files = find_fonts();
    if (files.text.empty()) GTEST_SKIP() << "no font is installed; fonts-inter has one";
    InterfaceFonts fonts(files);
    fonts.load(atlas, 17.0f);
    EXPECT_EQ(fonts.problem(), "");
    ASSERT_EQ(atlas.Fonts.Size, 2) << "text and headings";
    const auto all = [&](unsigned first, unsigned last) {
        for (unsigned code = first; code <= last; ++code)
            EXPECT_TRUE(has(ImWchar(code))) << std::hex << code;
    };
    all(0x21, 0x7e);
    all(0xa1, 0x17f);
    all(0x391, 0x3a1);
    all(0x3a3, 0x3c9);
    all(0x400, 0x45f);
    all(0x2013, 0x2014);  // dashes
    all(0x20ac, 0x20ac);
    EXPECT_TRUE(files.icons.empty() || has(0xf005)) << "the star of favourites";
}

TEST_F(Fonts, OtherScriptsComeWithTheTextsThatHaveThem) {
    const FontFiles files = find_fonts();
    if (files.scripts.empty()) GTEST_SKIP() << "fonts-droid-fallback is not installed";
    InterfaceFonts fonts(files);
    fonts.load(atlas, 17.0f);
    EXPECT_FALSE(has(0x6728));
    fonts.meet("oak \xe2\x80\x94 \xce\xbb");
    EXPECT_FALSE(fonts.has_news()) << "a dash and a Greek letter are there already";
    fonts.meet("\xe6\x9c\xa8\xe7\x9b\xae");  // the grain of wood, in Japanese
    ASSERT_TRUE(fonts.has_news());
    fonts.load(atlas, 17.0f);
    EXPECT_FALSE(fonts.has_news());
    EXPECT_TRUE(has(0x6728));
    EXPECT_TRUE(has(0x76ee));
    EXPECT_FALSE(has(0x77f3)) << "of thousands only those that a text has";
    fonts.meet("\xff\xfe\xe6 \xc3");  // no UTF-8
    fonts.meet("\xe6\x9c\xa8");
    fonts.load(atlas, 17.0f);
    EXPECT_TRUE(has(0x6728));
}

}  // namespace
}  // namespace burl
