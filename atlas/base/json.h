#pragma once
// nlohmann::json, whose destructors do not end the process where memory has ended: its arrays and
// objects, and what destructors flatten them into, take LastMemoryAllocator's memory. This header
// is the only one that includes json.hpp, for all values must be made and destroyed by one
// allocator.
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "atlas/base/last_memory.h"

/// The parts of std::allocator that its specialisations need.
#define BURL_LAST_MEMORY(...)                                                                 \
    template <>                                                                               \
    class std::allocator<__VA_ARGS__> : public burl::LastMemoryAllocator<__VA_ARGS__> {       \
      public:                                                                                 \
        using size_type = std::size_t;                                                        \
        using difference_type = std::ptrdiff_t;                                               \
        using propagate_on_container_move_assignment = std::true_type;                        \
        using is_always_equal = std::true_type;                                               \
        constexpr allocator() noexcept = default;                                             \
        template <class Other>                                                                \
        constexpr allocator(const std::allocator<Other>&) noexcept {}                         \
        friend constexpr bool operator==(const allocator&, const allocator&) { return true; } \
    }

BURL_LAST_MEMORY(nlohmann::json);
BURL_LAST_MEMORY(std::vector<nlohmann::json>);
BURL_LAST_MEMORY(std::map<std::string, nlohmann::json, std::less<>>);
BURL_LAST_MEMORY(nlohmann::ordered_json);
BURL_LAST_MEMORY(std::vector<nlohmann::ordered_json>);
BURL_LAST_MEMORY(
    nlohmann::ordered_map<std::string, nlohmann::ordered_json, std::less<>,
                          std::allocator<std::pair<const std::string, nlohmann::ordered_json>>>);
#undef BURL_LAST_MEMORY

#include <nlohmann/json.hpp>
