#include "app/base/version.h"

#include <algorithm>

#include <OpenEXR/OpenEXRConfig.h>
#include <OpenMesh/Core/System/config.h>
#include <fmt/format.h>
#include <gif_lib.h>
#include <png.h>
#include <tbb/version.h>
#include <webp/encode.h>
#include <CLI/Version.hpp>
#include <glm/glm.hpp>

#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "procedural/batch/texel_batch.h"
#include "procedural/numbers/simd_target.h"

namespace burl {

std::string burl_version() {
    return BURL_VERSION;
}

namespace {

/// A version in three bytes, as libwebp tells it.
std::string three_bytes(int version) {
    return fmt::format("{}.{}.{}", version >> 16, version >> 8 & 255, version & 255);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> component_versions() {
    return {
        {"OpenMesh", fmt::format("{}.{}", OM_GET_VER, OM_GET_MAJ)},
        {"tinygltf", TINYGLTF_VERSION_TEXT},
        {"GLM", fmt::format("{}.{}.{}.{}", GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH,
                            GLM_VERSION_REVISION)},
        {"fmt",
         fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
        {"CLI11", CLI11_VERSION},
        {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                                      NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
        {"oneTBB", TBB_runtime_version()},
        {"Highway", HWY_VERSION_TEXT},
        {"libpng", png_get_libpng_ver(nullptr)},
        {"libwebp", three_bytes(WebPGetEncoderVersion())},
        {"giflib", fmt::format("{}.{}.{}", GIFLIB_MAJOR, GIFLIB_MINOR, GIFLIB_RELEASE)},
        {"OpenEXR", OPENEXR_VERSION_STRING},
        {"simd", simd_level()},
    };
}

std::string version_text() {
    std::string text = fmt::format("burl {}", burl_version());
    for (const auto& [name, version] : component_versions()) {
        text += fmt::format("\n  {} {}", name, version);
    }
    return text;
}

void limit_simd(const std::string& level) {
    const std::vector<std::string> names = simd_targets();
    if (std::ranges::find(names, level) == names.end())
        throw Error(ExitCode::usage, fmt::format("--simd {}: must be one of this machine's, {}",
                                                 level, fmt::join(names, ", ")));
    use_simd_target(level);
}

}  // namespace burl
