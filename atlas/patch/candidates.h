#pragma once
// Which division into patches is best: several partitions and the mesh's own creases are mapped and
// packed, and the one with the least predicted stretch is kept. A large mesh's partitions are
// judged on a coarser one, and only the best is carried over.
#include "atlas/patch/layout.h"
#include "atlas/patch/maps.h"

namespace burl {

struct PatchCandidate {
    PatchMaps maps;      ///< descended on as far as judging needs
    PatchLayout layout;  ///< empty when the patches do not fit
    /// S1 (1 + 0.005 patches), 1.5 times that for every time the gutter was halved; infinite when
    /// nothing fits.
    double cost = 0.0;
    int looked_at = 1;  ///< divisions judged
};

/// `tries`: partitions to choose from, 1 to 6; creases are judged besides where they divide the
/// mesh into some large parts. Pure and deterministic for any number of threads. Of no use, and
/// early, once `stop` is asked for.
PatchCandidate best_candidate(const Mesh& mesh, const Connectivity& connectivity,
                              std::uint32_t size, int tries, const std::stop_token& stop = {});

}  // namespace burl
