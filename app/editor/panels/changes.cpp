#include "app/editor/panels/changes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace burl {

namespace {

constexpr std::size_t most_rectangles = 6;

bool equal(const ImVec2& a, const ImVec2& b) {
    return a.x == b.x && a.y == b.y;
}

bool equal(const ScreenRect& a, const ScreenRect& b) {
    return equal(a.low, b.low) && equal(a.high, b.high);
}

/// The AABB of two rectangles; empty ones do not count.
ScreenRect around(const ScreenRect& a, const ScreenRect& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

/// Adds a dirty rectangle; beyond most_rectangles the last one grows to hold it.
void add(std::vector<ScreenRect>& rectangles, const ScreenRect& rectangle) {
    if (rectangle.empty()) return;
    if (rectangles.size() < most_rectangles)
        rectangles.push_back(rectangle);
    else
        rectangles.back() = around(rectangles.back(), rectangle);
}

}  // namespace

ScreenRect common(const ScreenRect& a, const ScreenRect& b) {
    return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
            {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

std::vector<ScreenChanges::Piece> ScreenChanges::pieces_of(const ImDrawData& data) {
    std::vector<Piece> pieces;
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            Piece& piece = pieces.emplace_back();
            const ImVec4& clip = command.ClipRect;
            piece.clip = {{clip.x, clip.y}, {clip.z, clip.w}};
            piece.texture = command.GetTexID();
            piece.triangles.resize(command.ElemCount / 3);
            const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset;
            const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
            for (Triangle& triangle : piece.triangles)
                for (ImDrawVert& corner : triangle.corners) corner = vertices[*index++];
        }
    }
    return pieces;
}

/// The AABB of the triangles [begin, end) of a draw command, with a margin of a pixel, clipped to
/// the command's rectangle.
ScreenRect ScreenChanges::extent(const Piece& piece, std::size_t begin, std::size_t end) {
    constexpr float far = std::numeric_limits<float>::max();
    ScreenRect box{{far, far}, {-far, -far}};
    for (std::size_t i = begin; i < end; ++i)
        for (const ImDrawVert& corner : piece.triangles[i].corners) {
            box.low = {std::min(box.low.x, corner.pos.x), std::min(box.low.y, corner.pos.y)};
            box.high = {std::max(box.high.x, corner.pos.x), std::max(box.high.y, corner.pos.y)};
        }
    if (begin == end) return {};
    return common(piece.clip, {{std::floor(box.low.x) - 1.0f, std::floor(box.low.y) - 1.0f},
                               {std::ceil(box.high.x) + 1.0f, std::ceil(box.high.y) + 1.0f}});
}

/// Adds the dirty rectangle of a draw command whose clip rectangle and texture have not changed:
/// the AABB of the triangles that are left without the common first and last ones.
void ScreenChanges::compare(const Piece& before, const Piece& now,
                            std::vector<ScreenRect>& changes) {
    const std::vector<Triangle>&a = before.triangles, &b = now.triangles;
    const auto same = [](const Triangle& p, const Triangle& q) {
        return std::memcmp(&p, &q, sizeof(Triangle)) == 0;
    };
    const std::size_t least = std::min(a.size(), b.size());
    std::size_t begin = 0, end = 0;
    while (begin < least && same(a[begin], b[begin])) ++begin;
    while (end < least - begin && same(a[a.size() - 1 - end], b[b.size() - 1 - end])) ++end;
    add(changes, around(extent(before, begin, a.size() - end), extent(now, begin, b.size() - end)));
}

std::vector<ScreenRect> ScreenChanges::update(const ImDrawData& data,
                                              const std::function<bool(ImTextureID)>& still) {
    const std::vector<Piece> before = std::exchange(last_, pieces_of(data));
    const bool resized =
        !equal(std::exchange(size_, data.DisplaySize), data.DisplaySize) ||
        !equal(std::exchange(scale_, data.FramebufferScale), data.FramebufferScale);
    if (resized || before.size() != last_.size()) return {{{0.0f, 0.0f}, data.DisplaySize}};
    std::vector<ScreenRect> changes;
    for (std::size_t i = 0; i < last_.size(); ++i) {
        const Piece &old = before[i], &now = last_[i];
        if (equal(old.clip, now.clip) && old.texture == now.texture && still(now.texture))
            compare(old, now, changes);
        else
            add(changes,
                around(extent(old, 0, old.triangles.size()), extent(now, 0, now.triangles.size())));
    }
    return changes;
}

}  // namespace burl
