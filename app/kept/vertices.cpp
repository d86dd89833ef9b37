#include "app/kept/vertices.h"

#include <algorithm>

namespace burl {
namespace {

constexpr std::uint32_t no_vertex = 0xffffffffu;

}  // namespace

KeptVertices::KeptVertices(std::size_t count)
    : file_count_(count), vertices_(count), bits_(count), next_(count, no_vertex) {
    for (std::size_t i = 0; i < count; ++i)
        vertices_[i] = {std::uint32_t(i), std::uint32_t(i), no_corner};
}

std::uint32_t KeptVertices::of(std::uint32_t a, std::uint32_t b, const CornerBits& bits,
                               std::size_t corner) {
    if (a > b) std::swap(a, b);
    std::uint32_t vertex = a;
    if (a != b) {
        const auto fresh = std::uint32_t(vertices_.size());
        const auto [entry, is_new] = middles_.try_emplace(std::uint64_t{a} << 32 | b, fresh);
        vertex = entry->second;
        if (is_new) {
            vertices_.push_back({a, b, corner});
            bits_.push_back(bits);
            next_.push_back(no_vertex);
            return vertex;
        }
    } else if (vertices_[a].corner == no_corner) {
        vertices_[a].corner = corner;
        bits_[a] = bits;
        return a;
    }
    while (bits_[vertex] != bits) {
        if (next_[vertex] == no_vertex) {
            next_[vertex] = std::uint32_t(vertices_.size());
            vertices_.push_back({a, b, corner});
            bits_.push_back(bits);
            next_.push_back(no_vertex);
        }
        vertex = next_[vertex];
    }
    return vertex;
}

}  // namespace burl
