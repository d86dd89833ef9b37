#include "app/surface/mesh_notes.h"

#include <fmt/format.h>

namespace burl {

std::vector<std::string> sentences_of(const MeshNotes& notes) {
    const struct {
        std::uint64_t count;
        const char *one, *many, *fate;
    } counts[] = {
        {notes.degenerate_triangles, "triangle", "triangles",
         "without area (kept; nothing to texture)"},
        {notes.duplicate_triangles, "duplicate triangle", "duplicate triangles", "(kept)"},
        {notes.unreferenced_points, "point", "points", "that no face uses (left out)"},
        {notes.ignored_elements, "element", "elements", "other than faces (left out)"},
    };
    std::vector<std::string> sentences;
    for (const auto& [count, one, many, fate] : counts)
        if (count != 0)
            sentences.push_back(fmt::format("{} {} {}", count, count == 1 ? one : many, fate));
    sentences.insert(sentences.end(), notes.sentences.begin(), notes.sentences.end());
    return sentences;
}

}  // namespace burl
