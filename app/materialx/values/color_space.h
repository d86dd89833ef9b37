#pragma once
// Colour spaces that a document's colours may be in.
#include <string_view>
#include <vector>

namespace burl::materialx {

/// Takes the first three numbers of a colour to linear light with the primaries of Rec. 709; false
/// where the space is not known. Colours without a space are there already.
bool to_linear(std::string_view space, std::vector<double>& color);

/// Whether the space is that of colours which need no change.
bool is_linear(std::string_view space);

}  // namespace burl::materialx
