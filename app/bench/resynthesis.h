#pragma once
// The suite `burl bench resynthesis`: what the next texture costs when one thing of the last one
// was edited, beside a synthesis from scratch.
#include <vector>

#include "app/bench/result.h"
#include "app/bench/synthesis.h"

namespace burl {

/// One thread, 8 bits; mesh, layout and spans are ready before the clock starts. In every round
/// each case makes one edit of its kind to the texture of the case before, in which the recipe's
/// first noise term is taken apart into terms of one octave and the last of them is edited. `From
/// scratch` is the recipe as it is. Throws Error for recipes that cannot be read, and for graphs,
/// filters and precisions, of which nothing is kept.
std::vector<BenchResult> bench_resynthesis(int repeats, SynthesisSubjects subjects);

}  // namespace burl
