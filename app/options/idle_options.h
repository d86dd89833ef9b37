#pragma once
// Options and edits on the command line that would have no effect are refused, since their user
// expects one. Numbers without effect in a recipe's file are accepted.
#include <span>
#include <string>
#include <string_view>

#include "app/options/command_options.h"
#include "procedural/batch/kernel.h"

namespace burl {

/// The reason why a number of the recipe has no effect on its textures, with a remedy; empty where
/// it has one.
std::string idle_reason(const Recipe& recipe, std::string_view path);

/// Throws Error(usage) for an edit, or for a move (--animate PATH=FROM:TO), of a number without
/// effect (idle_reason). `recipe` is the result of the options.
void check_edits(const RecipeOptions& options, const Recipe& recipe,
                 std::span<const std::string> moves = {});

/// The reason why a kernel (--kernel, app/bake/options.h) has no effect on the recipe's
/// texture; empty where it has one.
std::string idle_kernel(const Recipe& recipe, Kernel kernel);

/// A key of recipes, and the reason why it has no effect in a verb.
struct IdleKey {
    std::string_view key, why;
};

/// Throws Error(usage) for a --set, or for a move (--animate PATH=FROM:TO), of one of the keys or
/// of a key below it.
void refuse_edits(const RecipeOptions& options, std::span<const IdleKey> keys,
                  std::span<const std::string> moves = {});

/// The key that has no effect on meshes without a pose.
inline constexpr IdleKey idle_pose{"pose", "there is no --pose"};

}  // namespace burl
