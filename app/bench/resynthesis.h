#pragma once
// The suite `burl bench resynthesis`: the time of the next texture after an edit, with intermediate
// values cached, beside a synthesis from scratch.
#include <vector>

#include "app/bench/result.h"
#include "app/bench/synthesis.h"

namespace burl {

/// Measures textures on one thread in 8 bits; mesh, layout and spans are not timed. In every round
/// a case makes one edit of its kind to the texture of its round before, in which the recipe's
/// first noise term is split into one term per octave, and the last of these is edited. "From
/// scratch" is the recipe itself. Throws Error for recipes that cannot be read, and for graphs,
/// filters and precisions, for which nothing is cached.
std::vector<BenchResult> bench_resynthesis(int repeats, SynthesisSubjects subjects);

}  // namespace burl
