#include "app/editor/widgets/fonts.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <imgui_freetype.h>
#include <imgui_internal.h>

#include "app/base/file_bytes.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

constexpr std::array text_files{
    "/usr/share/fonts/opentype/inter/Inter-Regular.otf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
};
constexpr std::array heading_files{
    "/usr/share/fonts/opentype/inter/Inter-SemiBold.otf",
    "/usr/share/fonts/truetype/noto/NotoSans-Bold.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Bold.ttf",
};
constexpr std::array icon_files{
    "/usr/share/fonts/truetype/font-awesome/fontawesome-webfont.ttf",
};
constexpr std::array symbol_files{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
};
constexpr std::array script_files{
    "/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf",
    "/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc",
};

/// Latin with its extensions, Greek, Cyrillic, punctuation, currencies, arrows and the minus sign.
constexpr std::array<std::pair<ImWchar, ImWchar>, 8> usual_ranges{{{0x0020, 0x024f},
                                                                   {0x0300, 0x052f},
                                                                   {0x1e00, 0x1fff},
                                                                   {0x2010, 0x205e},
                                                                   {0x20a0, 0x20bf},
                                                                   {0x2190, 0x2199},
                                                                   {0x2212, 0x2212},
                                                                   {0xfffd, 0xfffd}}};
constexpr std::array<ImWchar, 3> icon_ranges{0xf000, 0xf2e0, 0};
constexpr float icon_share = 14.0f / 17.0f;  // icons are drawn for 14 pixels, beside lines of 17

bool is_usual(unsigned code) {
    for (const auto& [low, high] : usual_ranges)
        if (code >= low && code <= high) return true;
    return code < usual_ranges[0].first;
}

std::string first_there(const std::string& root, std::span<const char* const> candidates) {
    std::error_code unknown;
    for (const char* candidate : candidates)
        if (std::filesystem::is_regular_file(root + candidate, unknown)) return root + candidate;
    return {};
}

/// Returns zero-terminated pairs, as ImGui takes them.
std::vector<ImWchar> ranges_of(const std::set<ImWchar>& codes, bool usual) {
    std::vector<ImWchar> ranges;
    if (usual)
        for (const auto& [low, high] : usual_ranges) ranges.insert(ranges.end(), {low, high});
    for (const ImWchar code : codes) ranges.insert(ranges.end(), {code, code});
    ranges.push_back(0);
    return ranges;
}

}  // namespace

FontFiles find_fonts(const std::string& root) {
    return {first_there(root, text_files), first_there(root, heading_files),
            first_there(root, icon_files), first_there(root, symbol_files),
            first_there(root, script_files)};
}

void InterfaceFonts::meet(std::string_view text) {
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at < end) {
        unsigned code = 0;
        at += ImTextCharFromUtf8(&code, at, end);
        if (code == 0 || code > IM_UNICODE_CODEPOINT_MAX || is_usual(code)) continue;
        news_ |= met_.insert(ImWchar(code)).second;
    }
}

/// Returns the content of a file, read once; empty where it cannot be read.
std::vector<std::uint8_t>& InterfaceFonts::bytes_of(const std::string& file) {
    const auto [place, fresh] = bytes_.try_emplace(file);
    if (!fresh) return place->second;
    try {
        place->second = read_file_bytes(file);
    } catch (const Error& error) {
        problem_ = error.what();
    }
    return place->second;
}

bool InterfaceFonts::add(ImFontAtlas& atlas, const std::string& file, ImFontConfig config) {
    if (file.empty()) return false;
    std::vector<std::uint8_t>& bytes = bytes_of(file);
    if (bytes.empty()) return false;
    config.FontDataOwnedByAtlas = false;
    atlas.AddFontFromMemoryTTF(bytes.data(), int(bytes.size()), config.SizePixels, &config);
    return true;
}

/// Adds a font with what it lacks and the icons.
bool InterfaceFonts::add_family(ImFontAtlas& atlas, const std::string& file, float pixels) {
    ImFontConfig config;
    config.SizePixels = pixels;
    config.GlyphRanges = usual_.data();
    if (!add(atlas, file, config)) return false;
    config.MergeMode = true;
    if (files_.symbols != file) add(atlas, files_.symbols, config);
    config.GlyphRanges = unusual_.data();
    if (!met_.empty()) add(atlas, files_.scripts, config);
    config.GlyphRanges = icon_ranges.data();
    config.SizePixels = std::round(icon_share * pixels);
    config.GlyphMinAdvanceX = config.GlyphMaxAdvanceX = pixels;
    add(atlas, files_.icons, config);
    return true;
}

void InterfaceFonts::load(ImFontAtlas& atlas, float pixels) {
    news_ = false;
    problem_.clear();
    usual_ = ranges_of(met_, true);
    unusual_ = ranges_of(met_, false);
    atlas.Clear();
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    const bool found =
        add_family(atlas, files_.text, pixels) &&
        (add_family(atlas, files_.heading, pixels) || add_family(atlas, files_.text, pixels));
    if (found && atlas.Build()) return;
    if (problem_.empty())
        problem_ = found
                       ? fmt::format("{}: cannot be used as a font", files_.text)
                       : "no font for text is installed; install fonts-inter or fonts-dejavu-core "
                         "for names that are not in Latin letters";
    atlas.Clear();
    ImFontConfig own;
    own.SizePixels = std::round(pixels * 13.0f / 17.0f);
    atlas.AddFontDefault(&own);
    atlas.Build();
}

ImFont* heading_font() {
    const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
    return fonts.size() > 1 ? fonts[1] : fonts[0];
}

bool has_glyph(ImWchar code) {
    return ImGui::GetFont()->FindGlyphNoFallback(code) != nullptr;
}

}  // namespace burl
