#pragma once
// The pieces and breaks of a shader's colour maps (color/map_pieces.h) as constant arrays, for
// shaders/graph/dual_map.glsl.
#include "procedural/color/map_pieces.h"
#include "procedural/glsl/text.h"

namespace burl {

class GlslMapTables {
  public:
    explicit GlslMapTables(GlslReal real) : real_(real) {}

    /// Adds a map and returns the expression, of type PieceMap, that stands for it.
    std::string add(const ColorMap& map);
    /// The declarations of the arrays, none of them empty.
    std::string text() const;

  private:
    GlslReal real_;
    std::vector<MapPieces::Piece> pieces_;
    std::vector<MapBreak> breaks_;
};

}  // namespace burl
