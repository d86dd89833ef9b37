#include "app/bake/normals.h"

#include "atlas/base/error.h"

namespace burl {

NormalSpace normals_asked(const std::string& text, const Recipe& recipe,
                          const std::string& out_path) {
    if (text == "none") return NormalSpace::none;
    if (recipe.bump.empty()) {
        if (text.empty()) return NormalSpace::none;
        throw Error(
            ExitCode::usage,
            fmt::format("--normals {}: the recipe has no \"bump\" to make normals of; give it "
                        "one, such as --set 'bump.input={{\"node\": \"fbm\"}}'",
                        text));
    }
    if (text != "object") return NormalSpace::tangent;
    if (is_gltf(out_path))
        throw Error(ExitCode::usage,
                    fmt::format("{}: glTF knows normals in tangent space only; use --normals "
                                "tangent, or write a .png, .exr or .obj",
                                out_path));
    return NormalSpace::object;
}

std::optional<NormalMap> bake_normals(Pipeline& pipeline, NormalSpace space, int depth,
                                      double crease_degrees) {
    if (space == NormalSpace::none) return std::nullopt;
    const bool tangent = space == NormalSpace::tangent;
    if (depth == 16) return NormalMap{pipeline.normal_map<Rgb16>(crease_degrees, tangent), tangent};
    return NormalMap{pipeline.normal_map<Rgb8>(crease_degrees, tangent), tangent};
}

}  // namespace burl
