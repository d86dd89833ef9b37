#pragma once
// The fonts of the user interface, from files of Debian's packages: fonts-inter, or another font
// that has all of Latin, Greek and Cyrillic; icons of fonts-font-awesome; and for the characters of
// other scripts fonts-droid-fallback, of which only those are rasterised that some text has.
#include <imgui.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace burl {

/// Files of fonts; an empty name: none is installed.
struct FontFiles {
    std::string text{}, heading{}, icons{};
    std::string symbols{};  ///< for characters that `text` lacks
    std::string scripts{};  ///< for scripts of many thousand characters
};

/// The installed fonts below the folder `root` ("" for the system), the best for each purpose.
FontFiles find_fonts(const std::string& root = "");

/// The fonts of one user interface. ImGui's font atlas refers to its memory, so it must outlive
/// that.
class InterfaceFonts {
  public:
    explicit InterfaceFonts(FontFiles files) : files_(std::move(files)) {}

    /// Notes characters of a text in UTF-8 that will be shown; malformed bytes count as none.
    void meet(std::string_view text);
    /// Whether load() would add characters since its last call.
    bool has_news() const { return news_; }
    /// Replaces the atlas's fonts: number 0 is for text, number 1 for headings. `pixels` is the
    /// height of a line of text. Dear ImGui's own font, which has Latin-1 alone, stands in where no
    /// file is installed or can be read; problem() says so.
    void load(ImFontAtlas& atlas, float pixels);
    /// A sentence about fonts that are missing; empty: none.
    const std::string& problem() const { return problem_; }

  private:
    bool add(ImFontAtlas& atlas, const std::string& file, ImFontConfig config);
    bool add_family(ImFontAtlas& atlas, const std::string& file, float pixels);
    std::vector<std::uint8_t>& bytes_of(const std::string& file);

    FontFiles files_;
    std::set<ImWchar> met_;
    bool news_ = false;
    std::string problem_;
    std::vector<ImWchar> usual_, unusual_;  ///< glyph ranges of the fonts loaded last
    std::map<std::string, std::vector<std::uint8_t>> bytes_;  ///< contents of font files
};

/// The font of headings in ImGui's current context.
ImFont* heading_font();

/// Whether ImGui's current font has this character.
bool has_glyph(ImWchar code);

}  // namespace burl
