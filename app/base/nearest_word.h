#pragma once
// The word that somebody may have meant.
#include <span>
#include <string_view>

namespace burl {

/// The candidate with the smallest edit distance to `word`; empty when there is none that shares
/// more than it lacks.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace burl
