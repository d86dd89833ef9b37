#pragma once
// One spelling for every file, so that two names of one output are noticed before it is written
// twice.
#include <string>

namespace burl {

/// The file a chain of symbolic links ends at, existing or not.
std::string follow_links(const std::string& path);

/// The absolute path without links, "." and ".."; of a file that is not there yet as far as its
/// folders are. The path itself where it cannot be found out.
std::string real_path(const std::string& path);

}  // namespace burl
