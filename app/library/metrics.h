#pragma once
// How good an atlas is: the figures of `burl metrics` (docs/reference/metrics.md).
#include <cstdint>
#include <string>

#include "app/library/mesh.h"
#include "app/library/recipe.h"

namespace burl::library {

/// The options of metrics().
struct MetricsOptions {
    /// Kind of atlas, as in BakeOptions, or "all" for one of each but "uv"; empty: as the recipe
    /// says.
    std::string atlas{};
    /// Texels a side, 1 to 16384; 0: as the recipe says.
    std::uint32_t size = 0;
    /// Whether the mesh's own texture coordinates are measured, too, as "uv".
    bool own_uvs = false;
    /// Whether lookups are measured, too: errors per MIP level, seams, bleeding. Takes seconds.
    bool lookups = false;
    /// Is told how far the measuring is; empty: nobody is.
    Progress progress{};
};

/// The figures of atlases of the mesh, as the JSON text of `burl metrics --json`: "mesh" and
/// "atlases", an array. The texture that is looked up is the recipe's. Throws Error: usage for
/// options out of range and for texture coordinates that the mesh lacks, unsupported for textures
/// that are not square, stopped where the callback says so, and as bake() does.
BURL_API std::string metrics(const Mesh& mesh, const Recipe& recipe,
                             const MetricsOptions& options = {});

/// The number at a place of a JSON text, a JSON pointer (RFC 6901) such as "/atlases/0/coverage",
/// for programs that have no reader of JSON. Throws Error(usage) where there is no number.
BURL_API double number_at(const std::string& json, const std::string& pointer);

}  // namespace burl::library
