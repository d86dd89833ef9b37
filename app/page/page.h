#pragma once
// A web page of baked objects: a folder with index.html, the viewer (viewer/, with three.js), and
// the objects, their pictures and Burl's lights as scripts. It is shown without a network and
// without a server.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "atlas/base/image.h"

namespace burl {

/// An object of a page.
struct PageObject {
    std::string path;  ///< of its .glb
    std::string name;  ///< the name that visitors read, unlike those of the page's other objects
    std::string file;  ///< its name in the page: letters, digits and '-'
    std::optional<Image<Rgba8>> picture{};
};

/// The names of files as names of a page's objects: without folders and extension, with a number
/// where that is no name of one alone. Throws Error(usage) where a file is none that ends in .glb.
std::vector<PageObject> page_objects(std::span<const std::string> paths);

/// Checks that a page can show the file of an object: that it holds all that it needs, and that
/// its extensions are the viewer's. Throws Error: as load_gltf does; unsupported.
void check_page_object(const std::string& path);

/// Whether this program holds the viewer, which is made where esbuild and three.js are found at
/// build time (docs/build.md).
bool has_page_viewer();

/// The paths of the page's files in the folder, index.html last.
std::vector<std::string> page_files(const std::string& folder, std::span<const PageObject> objects);

/// The files, sorted and seen from the folder, among its objects that no page of these objects has.
std::vector<std::string> left_of_older_page(const std::string& folder,
                                            std::span<const PageObject> objects);

/// Throws Error(io) where the folder has an index.html that no `burl page` wrote, or none and
/// files that a page of the objects would replace.
void check_page_folder(const std::string& folder, std::span<const PageObject> objects);

/// Writes the page, index.html last; its folders must be there. Throws Error: unsupported without a
/// viewer, io.
void write_page(const std::string& folder, const std::string& title,
                std::span<const PageObject> objects);

}  // namespace burl
