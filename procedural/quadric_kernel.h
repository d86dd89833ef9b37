#pragma once
// The quadric of the texture along the lines of pieces: a parabola each, several pieces at once.
#include <span>

#include "procedural/texel_piece.h"

namespace burl {

/// parabolas[i] = q + constant along pieces[i]; as many of both.
void make_parabolas(const Quadric& quadric, double constant, std::span<const Piece> pieces,
                    std::span<ParabolaLine> parabolas);

}  // namespace burl
