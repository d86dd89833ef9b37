#pragma once
// The relief of a surface: its displacement, and the bumps of its normal.
#include <optional>

#include "app/materialx/shader_inputs.h"

namespace burl::materialx {

/// The height that a material's displacement gives, or the node of its normal if that makes one of
/// a height; none where it has neither. Normals that come from elsewhere are noted as lost.
std::optional<NodeRef> read_height(const ShaderInputs& inputs, std::string_view normal,
                                   const Target& displacement);

}  // namespace burl::materialx
