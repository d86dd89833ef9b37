#include "app/options/economy_options.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "app/options/command_options.h"

namespace burl {

namespace {

constexpr double megabyte = 1024.0 * 1024.0, usual_megabytes = 1024.0, most_megabytes = 1 << 20;

std::vector<std::string> skip_words() {
    std::vector<std::string> words(skip_names.begin(), skip_names.end());
    words.emplace_back(all_skips);
    return words;
}

}  // namespace

void EconomyOptions::add_skips(CLI::App& verb) {
    verb.add_option("--no-skip", forbidden,
                    "Do work that is otherwise left out, by its name, or all; may be repeated. "
                    "The result is the same")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->check(one_of(skip_words()));
}

void EconomyOptions::add_cache(CLI::App& verb) {
    verb.add_option("--cache", cache_megabytes,
                    "Memory for what one texture leaves to the next, in MB (1024 for --frames, "
                    "else 0)")
        ->check(in_range(0.0, most_megabytes));
}

Skips EconomyOptions::skips() const {
    Skips skips;
    for (std::size_t k = 0; k < skip_names.size(); ++k)
        if (std::ranges::any_of(forbidden, [&](const std::string& word) {
                return word == skip_names[k] || word == all_skips;
            }))
            skips.forbid(Skip(k));
    return skips;
}

std::size_t EconomyOptions::cache_bytes(bool several) const {
    return std::size_t(cache_megabytes.value_or(several ? usual_megabytes : 0.0) * megabyte);
}

}  // namespace burl
