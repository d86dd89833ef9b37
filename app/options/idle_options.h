#pragma once
// Options and edits on the command line that would change nothing are refused: whoever typed them
// believes that they do. What a recipe's file says beside the point is left alone.
#include <span>
#include <string>
#include <string_view>

#include "app/options/command_options.h"

namespace burl {

/// The reason for which a number of the recipe has no say in its textures, and what to do about it;
/// empty if it has one.
std::string idle_reason(const Recipe& recipe, std::string_view path);

/// Throws Error(usage) for an edit of a number that has no say (idle_reason), or one of `moves`
/// (--animate PATH=FROM:TO). `recipe`: what the options make.
void check_edits(const RecipeOptions& options, const Recipe& recipe,
                 std::span<const std::string> moves = {});

/// The reason for which a kernel (app/options/command_options.h: --kernel) has no say in the
/// recipe's texture, and what to do about it; empty if it has one.
std::string idle_kernel(const Recipe& recipe, Kernel kernel);

/// A key of recipes and what makes it idle in a verb.
struct IdleKey {
    std::string_view key, why;
};

/// Throws Error(usage) for a --set of one of the keys or of what lies below it.
void refuse_edits(const RecipeOptions& options, std::span<const IdleKey> keys);

/// Throws Error(usage) for a key over time (--animate PATH=...) of one of the keys or of what lies
/// below it.
void refuse_moves(std::span<const std::string> moves, std::span<const IdleKey> keys);

/// The key that has no say in meshes without a pose.
inline constexpr IdleKey idle_pose{"pose", "there is no --pose"};

}  // namespace burl
