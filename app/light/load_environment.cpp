#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

#include "app/image/exr_read.h"
#include "app/image/hdr_read.h"
#include "app/light/environment.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

bool has_ending(const std::string& path, std::string_view ending) {
    return path.size() > ending.size() &&
           std::ranges::equal(std::string_view(path).substr(path.size() - ending.size()), ending,
                              [](char a, char b) { return std::tolower(a) == b; });
}

Image<RgbF> read_light(const std::string& path) {
    if (has_ending(path, ".exr")) return read_exr(path);
    if (has_ending(path, ".hdr")) return read_hdr(path);
    throw Error(ExitCode::usage,
                fmt::format("{}: an environment is a file .exr or .hdr, or one of those that "
                            "`burl list environments` names",
                            path));
}

bool is_light(const RgbF& p) {
    const auto good = [](float c) { return c >= 0.0f && std::isfinite(c); };
    return good(p.r) && good(p.g) && good(p.b);
}

}  // namespace

Environment load_environment(const std::string& path) {
    Environment result{read_light(path)};
    const Image<RgbF>& map = result.radiance;
    if (map.width() != 2 * map.height())
        throw invalid_file(path, 0,
                           fmt::format("it has {} x {} pixels; a map of all directions is twice as "
                                       "wide as high",
                                       map.width(), map.height()));
    const auto wrong = std::ranges::find_if_not(map.pixels(), is_light);
    if (wrong != map.pixels().end()) {
        const auto at = std::size_t(wrong - map.pixels().begin());
        throw invalid_file(path, 0,
                           fmt::format("its light at pixel {}, {} is negative, infinite or no "
                                       "number",
                                       at % map.width(), at / map.width()));
    }
    return result;
}

}  // namespace burl
