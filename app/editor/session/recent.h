#pragma once
// The list of recently opened files, kept in the user's state folder.
#include <string>
#include <vector>

namespace burl {

inline constexpr std::size_t most_recent_files = 10;

/// A list of at most `most_recent_files` paths. All functions are called by one thread.
class RecentFiles {
  public:
    /// Reads the list from `file`, one path per line; an empty `file`: the list is not stored.
    explicit RecentFiles(std::string file);

    /// Puts a file that was opened or saved at the front and writes the list, merged with what
    /// other editors wrote since; names of samples and presets are ignored. A list that cannot be
    /// written is no longer stored, without a message.
    void add(const std::string& path);
    /// Absolute paths, newest first.
    const std::vector<std::string>& paths() const { return paths_; }

  private:
    void read();

    std::string file_;
    std::vector<std::string> paths_;
};

}  // namespace burl
