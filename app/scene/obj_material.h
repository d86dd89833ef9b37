#pragma once
// Materials of the libraries of an OBJ, by MTL and its extension for physically based rendering.
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/scene/material.h"
#include "atlas/base/named_files.h"

namespace burl {

/// A material of a library.
struct ObjMaterial {
    std::string library{};  ///< the path of the file that defines it
    SceneMaterial look{};
    /// Files of pictures by their keyword (map_Kd, norm, map_Pr ...), as written.
    std::map<std::string, std::string, std::less<>> maps{};
    /// The file that holds roughness and metallic together (app/export/obj.cpp); empty: none.
    std::string packed{};

    /// The file of this keyword; empty: none.
    std::string map(std::string_view keyword) const {
        const auto found = maps.find(keyword);
        return found == maps.end() ? std::string() : found->second;
    }
};

/// The materials of an OBJ, by the names that were asked for, and the libraries that were read.
struct ObjMaterials {
    std::vector<std::optional<ObjMaterial>> looks;  ///< in the names' order; no value: not found
    std::vector<std::string> files;
};

/// Finds materials in the libraries of the OBJ at `path`; of several with one name the first. What
/// is missing is said in the notes, sentences for stderr. Throws Error: io, invalid_file.
ObjMaterials find_obj_materials(const std::string& path, std::span<const std::string> libraries,
                                std::span<const std::string> names, NamedFiles named,
                                std::vector<std::string>& notes);

}  // namespace burl
