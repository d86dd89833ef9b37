#pragma once
// A batch of texels made without an atlas: pieces of rows in random directions.
#include <random>
#include <vector>

#include "procedural/batch/texel_batch.h"
#include "procedural/noise/spec.h"

namespace burl::test {

/// A noise whose corners neighbouring texels can share.
struct NoiseName {
    NoiseKind kind = NoiseKind::value;
    Fade fade = Fade::smooth;
};
inline constexpr NoiseName shared_noises[] = {{NoiseKind::value, Fade::linear},
                                              {NoiseKind::value, Fade::smooth},
                                              {NoiseKind::value, Fade::quintic},
                                              {NoiseKind::perlin, Fade::quintic}};

/// Returns the piece of texels `first` to first + count - 1 of a span of `length` texels.
inline Piece piece(const Vec3d& start, const Vec3d& step, double first, std::size_t count,
                   double length) {
    Piece result;
    result.solid = {start, step, first, count};
    result.length = length;
    return result;
}

inline Vec3d random_vector(std::mt19937& random, double size) {
    std::uniform_real_distribution<double> unit(-size, size);
    return {unit(random), unit(random), unit(random)};
}

/// Returns batch_capacity texels in pieces of 1 to 40, within `reach` of the origin. Their sides
/// are up to `side` long on every axis, and some are much shorter.
inline std::vector<Piece> random_batch(std::mt19937& random, double reach, double side) {
    std::vector<Piece> pieces;
    for (std::size_t left = batch_capacity; left > 0;) {
        const double size = side * std::ldexp(1.0, -int(random() % 6));
        Piece& piece = pieces.emplace_back();
        piece.solid = {random_vector(random, reach), random_vector(random, size),
                       double(random() % 30), std::min<std::size_t>(left, 1 + random() % 40)};
        piece.down = random_vector(random, size);
        piece.length = piece.solid.first + double(piece.solid.count);
        left -= piece.solid.count;
    }
    return pieces;
}

/// Calls visit(index of the texel in the batch, its piece, its centre) for every texel.
template <class Visit>
void for_each_texel(const std::vector<Piece>& pieces, const Visit& visit) {
    std::size_t at = 0;
    for (const Piece& piece : pieces)
        for (std::size_t j = 0; j < piece.solid.count; ++j)
            visit(at++, piece,
                  piece.solid.start + (piece.solid.first + double(j)) * piece.solid.step);
}

}  // namespace burl::test
