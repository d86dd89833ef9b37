#pragma once
// The choice of the division into patches: several partitions and the mesh's own creases are mapped
// and packed, and the division with the least predicted stretch is kept. Partitions of a large mesh
// are judged on a coarser one, and only the best are carried over.
#include "atlas/patch/layout.h"
#include "atlas/patch/maps.h"

namespace burl {

/// A division of the mesh into patches with their maps and their layout.
struct PatchCandidate {
    PatchMaps maps;      ///< maps, descended on as far as judging needs
    PatchLayout layout;  ///< layout, empty when the patches do not fit
    /// The predicted stretch S1 times (1 + 0.005 patches), times 1.5 for every halving of the
    /// gutter; infinite when the patches do not fit.
    double cost = 0.0;
    int looked_at = 1;  ///< number of divisions judged
};

/// The best of several divisions: `tries` partitions (1 to 6), and the mesh's creases where they
/// divide it into some large parts. Pure and deterministic for any number of threads. Returns
/// early, with a result that is of no use, once `stop` is requested.
PatchCandidate best_candidate(const Mesh& mesh, const Connectivity& connectivity,
                              std::uint32_t size, int tries, const std::stop_token& stop = {});

}  // namespace burl
