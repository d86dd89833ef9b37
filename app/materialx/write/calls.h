#pragma once
// MaterialX's own functions, which graphs evaluate by procedural/materialx, as its nodes.
#include <vector>

#include "app/materialx/write/nodes.h"
#include "procedural/materialx/call.h"

namespace burl::materialx {

/// The results of a function of these numbers: as many as it has.
std::vector<Operand> write_call(const MaterialXCall& call, const std::vector<Operand>& in,
                                XmlNodes& nodes);

}  // namespace burl::materialx
