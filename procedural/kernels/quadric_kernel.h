#pragma once
// The quadric of the texture along the lines of pieces: a parabola each, several pieces at once.
#include <span>

#include "procedural/batch/texel_piece.h"
#include "procedural/model/texture.h"

namespace burl {

/// Texels along a parabola: texel j has c0 + x (c1 + x c2) with x = first + j.
struct ParabolaLine {
    double c0 = 0.0, c1 = 0.0, c2 = 0.0;
    double first = 0.0;
    std::size_t count = 0;
};

/// parabolas[i] = q + constant along pieces[i]; as many of both.
void make_parabolas(const Quadric& quadric, double constant, std::span<const Piece> pieces,
                    std::span<ParabolaLine> parabolas);

/// values[j] = the parabolas, one line after the other.
void fill_parabolas(std::span<const ParabolaLine> lines, double* values);

}  // namespace burl
