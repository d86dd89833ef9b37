#pragma once
// What is fuzzed: one function per reader, which gets a file's bytes. It may throw Error; anything
// else (another exception, a report of a sanitizer, much time or memory) is a defect.
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "atlas/base/error.h"

namespace burl::fuzz {

/// The structure of a target's files, which mutations keep.
enum class Form { text, json, glb, png, binary };

struct Target {
    std::string_view name;
    void (*read)(const std::string& bytes);
    Form form = Form::binary;
    /// Files and folders of the checkout that are the first inputs, besides tests/fuzz/corpus/NAME.
    std::vector<std::string> seeds{};
    /// Words of the format; of JSON only those that no seed has.
    std::vector<std::string_view> words{};
    std::size_t most_bytes = 16384;
    std::vector<std::string> (*made)() = nullptr;  ///< further first inputs
};

std::vector<Target> mesh_targets();     ///< obj, off, ply, stl, obj-scene
std::vector<Target> gltf_targets();     ///< gltf
std::vector<Target> recipe_targets();   ///< recipe, settings, materialx
std::vector<Target> picture_targets();  ///< picture, exr, hdr
std::vector<Target> text_targets();     ///< manifest, script, points, record
std::vector<Target> soup_targets();     ///< soup

/// All of them.
std::vector<Target> all_targets();

/// The target of this name. Throws std::runtime_error that names all where there is none.
Target find_target(std::string_view name);

/// Reads the bytes; an Error is what bad files are for.
void run(const Target& target, const std::string& bytes);

/// The contents of all files that the target begins with, smallest first.
std::vector<std::string> first_inputs(const Target& target);

/// Does what may find the file wrong, which need not end what else is tried of it.
template <class Work>
void attempt(const Work& work) {
    try {
        work();
    } catch (const Error&) {
    }
}

/// Ends the program with the sentence unless it holds.
void require(bool holds, std::string_view sentence);

/// The path of a file with this content and name in a folder of this process, which its end
/// removes.
std::string scratch_file(const std::string& name, const std::string& content);

}  // namespace burl::fuzz
