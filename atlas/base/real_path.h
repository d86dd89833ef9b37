#pragma once
// Canonical paths, so that two names of one output file are noticed before it is written twice.
#include <string>

namespace burl {

/// The file that a chain of at most 40 symbolic links ends at, existing or not.
std::string follow_links(const std::string& path);

/// The absolute path without symbolic links, "." and "..". A file that does not exist is resolved
/// as far as its folders exist. Returns `path` unchanged where the system cannot resolve it.
std::string real_path(const std::string& path);

}  // namespace burl
