#pragma once
// The panel of parameters (parameters_panel of panels.h): a widget for each parameter of the table.
#include <cstdint>

#include <vector>

#include "app/editor/panels/panels.h"
#include "app/editor/widgets/leaf_widget.h"

namespace burl {

/// Draws a widget for each of these parameters; a change is one of the session.
void parameter_rows(const PanelContext& context, const std::vector<RecipeLeaf>& leaves);

/// Returns the random seed that a button puts in place of `seed`, the same in every run, so that
/// scripts repeat: the next one of a linear congruential generator with the full period 2^16.
/// Successive seeds are far apart, because octave k of a noise uses seed + k and neighbouring seeds
/// would share most octaves.
inline std::uint32_t next_seed(std::uint64_t seed) {
    return std::uint32_t((seed % 65536U) * 25173U + 13849U) % 65536U;
}

}  // namespace burl
