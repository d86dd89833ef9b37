#pragma once
// Whether early exits (early_exit.h) could pay for a texture at all, from its octaves' ranges
// alone: most textures need not pay for a pilot that finds nothing.
#include <span>
#include <vector>

#include "procedural/batch/economy.h"
#include "procedural/field/early_exit.h"
#include "procedural/model/octaves.h"
#include "procedural/model/texture.h"

namespace burl {

/// What the octave can add, without its offset.
OctaveRange octave_range(const Octave& octave);

/// exit_points() of a field without a band limit, less those that `skips` forbids; none: no texel
/// can be decided early.
std::vector<ExitPoint> allowed_exits(const ColorMap& colors, const std::vector<OctaveRange>& ranges,
                                     const Skips& skips);

/// Of a field that is nothing but octaves around `middle`, the shares of texels decided at `points`
/// of a map that does not repeat: as if every octave were normally distributed, more widely than
/// noise is. Little more is decided than that says.
std::vector<double> likely_shares(const std::vector<ExitPoint>& points,
                                  const std::vector<OctaveRange>& ranges, double middle);

/// Whether a pilot could find exits worth it (FieldSampler::plan_exit). Where a quadric moves the
/// field or the map repeats, only those without any place for an exit are ruled out.
bool may_exit(const Texture& texture, const Skips& skips, const ExitCosts& costs = {});

}  // namespace burl
