#pragma once
// The quadric of the texture along the lines of pieces: one parabola per piece, several at once.
#include <span>

#include "procedural/batch/texel_batch.h"
#include "procedural/model/texture.h"

namespace burl {

/// Texels along a parabola: texel j has the value c0 + x (c1 + x c2) with x = first + j.
struct ParabolaLine {
    double c0 = 0.0, c1 = 0.0, c2 = 0.0;
    double first = 0.0;
    std::size_t count = 0;
};

/// parabolas[i] = q + constant along pieces[i]; both spans have the same length.
void make_parabolas(const Quadric& quadric, double constant, std::span<const Piece> pieces,
                    std::span<ParabolaLine> parabolas);

/// values[j] = the value of texel j, where the texels of the lines are numbered one line after the
/// other.
void fill_parabolas(std::span<const ParabolaLine> lines, double* values);

}  // namespace burl
