#pragma once
// Values as other types, and their components in another order.
#include <optional>
#include <string_view>

#include "app/materialx/values/value.h"

namespace burl::materialx {

/// The value as another type, as MaterialX's node `convert` has it: a number in every component, or
/// the components in their order, a third that is missing being 0 and a fourth 1.
Value converted(Arithmetic& values, const Value& value, Type type);

/// The components that `channels` names, such as "xz" or "rgb1"; a single one in every component.
/// None where it names others.
std::optional<Value> swizzled(Arithmetic& values, const Value& value, std::string_view channels,
                              Type type);

}  // namespace burl::materialx
