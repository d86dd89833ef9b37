#pragma once
// Patterns of names: --mesh, --node, --material, --assign and --recipes.
#include <string_view>

namespace burl {

/// Whether the whole name fits the pattern, in which `*` stands for any characters, none included,
/// and `?` for one character (of UTF-8); all others, letters' case and `[` included, for
/// themselves. Takes time of at most the product of the lengths.
bool matches_glob(std::string_view name, std::string_view pattern);

}  // namespace burl
