#pragma once
// Mutations of files that keep their structure: JSON stays JSON, the chunks of a GLB keep true
// lengths, those of a PNG true checksums, text changes by lines and words.
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/json_text.h"
#include "tests/fuzz/target.h"

namespace burl::fuzz {

using Random = std::mt19937;

/// A number from 0 to count - 1; count must not be 0.
inline std::size_t below(Random& random, std::size_t count) {
    return std::size_t(random()) % count;
}

/// Words, keys and values that mutations put into JSON.
struct JsonPool {
    std::vector<std::string> words{};
    std::vector<std::pair<std::string, std::string>> members{};  ///< keys, with values as text
};

/// Adds all that the JSON holds.
void add_to_pool(const std::string& json, JsonPool& pool);

std::string mutated_json(const std::string& text, const JsonPool& pool, Random& random);
std::string mutated_text(const std::string& text, std::span<const std::string_view> words,
                         std::size_t most, Random& random);
std::string mutated_bytes(std::string bytes, Random& random);
/// The PNG with changed chunks.
std::string mutated_png(const std::string& bytes, Random& random);
/// The GLB or glTF with changed JSON or binary chunk.
std::string mutated_glb(const std::string& bytes, const JsonPool& pool, Random& random);

/// Changes files of a target.
class Mutator {
  public:
    explicit Mutator(const Target& target);

    /// One to four changes, in at most `most` bytes.
    std::string operator()(std::string bytes, std::size_t most, Random& random) const;

  private:
    std::string once(const std::string& bytes, std::size_t most, Random& random) const;

    Target target_;
    std::vector<std::string> inputs_;
    JsonPool pool_;
};

}  // namespace burl::fuzz
