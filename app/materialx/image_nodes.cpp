// Images.
#include <array>

#include "app/materialx/nodes.h"

namespace burl::materialx {

namespace {}  // namespace

std::span<const NodeRow> image_rows() {
    static constexpr std::array<NodeRow, 0> rows{};
    return rows;
}

}  // namespace burl::materialx
