// A page's files, read back by another way than they are written, and what a page refuses.
#include "app/page/page.h"

#include <algorithm>
#include <cmath>

#include "app/light/environment.h"
#include "app/page/data_script.h"
#include "atlas/base/json.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

using test::Scratch;

std::span<const std::uint8_t> bytes_of(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// The bytes of a text in base64, by the alphabet's definition alone.
std::string decoded(const std::string& text) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bits, bytes;
    for (const char c : text) {
        if (c == '=') continue;
        const std::size_t value = letters.find(c);
        for (int k = 5; k >= 0; --k) bits += (value >> k & 1) != 0 ? '1' : '0';
    }
    for (std::size_t i = 0; i + 8 <= bits.size(); i += 8)
        bytes += char(std::stoi(bits.substr(i, 8), nullptr, 2));
    return bytes;
}

/// The text between two marks of a file.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t from = text.find(begin) + begin.size();
    return text.substr(from, text.find(end, from) - from);
}

std::string baked(const Scratch& scratch, const std::string& name, const std::string& more = "") {
    const std::string path = scratch / name;
    EXPECT_EQ(
        test::run_burl(scratch, "bake sample:cube --size 32 -o '" + path + "' --quiet " + more)
            .exit_code,
        0);
    return path;
}

TEST(PageData, Base64IsThatOfRfc4648) {
    const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                           {"f", "Zg=="},
                                                           {"fo", "Zm8="},
                                                           {"foo", "Zm9v"},
                                                           {"foob", "Zm9vYg=="},
                                                           {"fooba", "Zm9vYmE="},
                                                           {"foobar", "Zm9vYmFy"}};
    for (const auto& [text, expected] : vectors) EXPECT_EQ(base64(bytes_of(text)), expected);
}

TEST(PageData, AScriptHasTheBytesInPieces) {
    std::string all;
    for (int i = 0; i < 500000; ++i) all += char(i * 7 + i / 251);
    std::string script;
    write_data_script("objects/a.js", bytes_of(all), [&](std::span<const std::uint8_t> piece) {
        script.append(reinterpret_cast<const char*>(piece.data()), piece.size());
    });
    EXPECT_EQ(between(script, "burlData(\"", "\""), "objects/a.js");
    EXPECT_EQ(decoded(between(script, "\",\"", "\"")), all);
}

TEST(PageData, LightIsRightToAHundredAndTwentyEighthOfItsLargestPart) {
    const Image<RgbF> light = make_environment("studio", 64).radiance;
    const std::vector<std::uint8_t> codes = rgbe_pixels(light.pixels());
    ASSERT_EQ(codes.size(), 4 * light.pixels().size());
    for (std::size_t i = 0; i < light.pixels().size(); ++i) {
        const RgbF& p = light.pixels()[i];
        const float most = std::max({p.r, p.g, p.b}), parts[] = {p.r, p.g, p.b};
        for (std::size_t c = 0; c < 3; ++c) {
            const double read = std::ldexp(codes[4 * i + c] + 0.5, codes[4 * i + 3] - 136);
            EXPECT_NEAR(read, parts[c], most / 255.9) << i;
        }
    }
    const RgbF dark[] = {{0.0f, 0.0f, 0.0f}};
    EXPECT_EQ(rgbe_pixels(dark), std::vector<std::uint8_t>(4, 0));
}

TEST(PageObjects, NamesAreUnlikeAndFilesArePlain) {
    const std::vector<std::string> paths{"a/Oak.glb", "b/Oak.glb", "c/oak.glb",
                                         "d/r\xc3\xb6hre 7!.glb"};
    const std::vector<PageObject> objects = page_objects(paths);
    EXPECT_EQ(objects[0].name, "Oak");
    EXPECT_EQ(objects[1].name, "Oak-2");
    EXPECT_EQ(objects[2].name, "oak-3");
    EXPECT_EQ(objects[3].name, "r\xc3\xb6hre 7!");
    EXPECT_EQ(objects[3].file, "r-hre-7");
    EXPECT_THROW(page_objects(std::vector<std::string>{"a.gltf"}), std::exception);
}

TEST(PageObjects, WhatAnOlderPageHadIsLeft) {
    const Scratch scratch;
    std::vector<PageObject> objects = page_objects(std::vector<std::string>{"gold.glb"});
    EXPECT_TRUE(left_of_older_page(scratch / "page", objects).empty());
    std::filesystem::create_directories(scratch / "page/objects");
    for (const char* name : {"gold.js", "gold.webp", "oak.webp", "oak.js"})
        scratch.write(std::string("page/objects/") + name, "");
    const std::vector<std::string> oak{"objects/oak.js", "objects/oak.webp"};
    std::vector<std::string> all = left_of_older_page(scratch / "page", objects);
    EXPECT_EQ(all, (std::vector<std::string>{"objects/gold.webp", oak[0], oak[1]}));
    objects[0].picture.emplace(2, 2);
    EXPECT_EQ(left_of_older_page(scratch / "page", objects), oak);
}

TEST(Page, HoldsItsObjectsAndTheirPictures) {
    if (!has_page_viewer()) GTEST_SKIP() << "built without the viewer of pages";
    const Scratch scratch;
    const std::string a = baked(scratch, "a.glb"), b = baked(scratch, "b.glb", "--recipe oak");
    const auto outcome = test::run_burl(
        scratch, "page '" + a + "' '" + b + "' --title 'A <!--<script> & \"c\"</script>' -o '" +
                     scratch / "page" + "'");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string html = test::slurp(scratch / "page/index.html");
    EXPECT_NE(html.find("<title>A &lt;!--&lt;script> &amp; &quot;c&quot;&lt;/script></title>"),
              std::string::npos);
    const std::string data = between(html, "application/json\">", "</script>");
    EXPECT_EQ(data.find('<'), std::string::npos) << "markup of HTML in a script";
    const auto contents = nlohmann::json::parse(data);
    EXPECT_EQ(contents["title"], "A <!--<script> & \"c\"</script>");
    ASSERT_EQ(contents["assets"].size(), 2u);
    EXPECT_EQ(contents["lights"].size(), environment_notes().size());
    EXPECT_EQ(contents["assets"][1]["name"], "b");
    const std::string script =
        test::slurp(scratch / ("page/" + contents["assets"][1]["file"].get<std::string>()));
    EXPECT_EQ(decoded(between(script, "\",\"", "\"")), test::slurp(b));
    EXPECT_EQ(test::slurp(scratch / "page/objects/b.webp").substr(8, 4), "WEBP");
    EXPECT_NE(test::slurp(scratch / "page/viewer.js").find("Three.js Authors"), std::string::npos)
        << "three.js without its licence";
    const auto again = test::run_burl(scratch, "page '" + a + "' -o '" + scratch / "page" + "'");
    EXPECT_EQ(again.exit_code, 0);
    EXPECT_NE(again.err.find("not of this page: objects/a.webp, objects/b.js and objects/b.webp\n"),
              std::string::npos)
        << again.err;
}

TEST(Page, SaysWhatItCannotShowAndLeavesWhatIsThere) {
    if (!has_page_viewer()) GTEST_SKIP() << "built without the viewer of pages";
    const Scratch scratch;
    const std::string a = baked(scratch, "a.glb"), outside = baked(scratch, "c.gltf");
    scratch.write("somebody.txt", "mine");
    std::filesystem::create_directories(scratch / "site");
    scratch.write("site/index.html", "<title>mine</title>");
    const std::pair<std::string, int> cases[] = {
        {"'" + a + "' -o '" + scratch / "site" + "'", 2},
        {"'" + a + "' -o '" + scratch / "somebody.txt" + "'", 2},
        {"'" + outside + "' -o '" + scratch / "page" + "'", 1},
        {"'" + scratch / "none.glb" + "' -o '" + scratch / "page" + "'", 2},
        {"'" + a + "' -o ''", 1},
        {"-o '" + scratch / "page" + "'", 1}};
    for (const auto& [arguments, code] : cases) {
        const auto outcome = test::run_burl(scratch, "page " + arguments);
        EXPECT_NE(outcome.exit_code, 0) << arguments;
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(scratch / "page")) << arguments;
        EXPECT_EQ(outcome.exit_code, code) << outcome.err;
    }
    EXPECT_EQ(test::slurp(scratch / "site/index.html"), "<title>mine</title>");
}

TEST(Page, ReplacesNoFilesButThoseOfAPage) {
    if (!has_page_viewer()) GTEST_SKIP() << "built without the viewer of pages";
    const Scratch scratch;
    const std::string a = baked(scratch, "a.glb");
    for (const std::string name :
         {"viewer.js", "objects/a.js", "objects/a.webp", "lights/studio.js"}) {
        std::filesystem::create_directories(scratch / "site/objects");
        std::filesystem::create_directories(scratch / "site/lights");
        scratch.write("site/" + name, "mine");
        const auto outcome =
            test::run_burl(scratch, fmt::format("page '{}' -o '{}'", a, scratch / "site"));
        EXPECT_EQ(outcome.exit_code, 2) << name << outcome.err;
        EXPECT_NE(outcome.err.find(name), std::string::npos) << outcome.err;
        EXPECT_TRUE(test::slurp(scratch / ("site/" + name)) == "mine") << name;
        EXPECT_FALSE(std::filesystem::exists(scratch / "site/index.html"));
        std::filesystem::remove_all(scratch / "site");
    }
    scratch.write("notes.txt", "mine");
    EXPECT_EQ(test::run_burl(scratch, fmt::format("page '{}' -o '{}'", a, scratch.path().string()))
                  .exit_code,
              0)
        << "beside files of other names";
}

TEST(Page, TakesNoFileThatNamesOthers) {
    const Scratch scratch;
    const std::string json = R"({"asset":{"version":"2.0"},"images":[{"uri":"there.png"}]} )";
    std::string glb = "glTF";
    const auto word = [&](std::uint32_t value) {
        for (int k = 0; k < 4; ++k) glb += char(value >> (8 * k) & 255);
    };
    std::string padded = json + std::string((4 - json.size() % 4) % 4, ' ');
    word(2), word(std::uint32_t(20 + padded.size())), word(std::uint32_t(padded.size()));
    glb += "JSON" + padded;
    const std::string path = scratch.write("a.glb", glb);
    try {
        check_page_object(path);
        ADD_FAILURE() << "was taken";
    } catch (const std::exception& error) {
        EXPECT_NE(std::string(error.what()).find("there.png"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace burl
