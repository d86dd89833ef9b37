#pragma once
// The files that were opened last, kept beside the user's other state for the next start.
#include <string>
#include <vector>

namespace burl {

inline constexpr std::size_t most_recent_files = 10;

class RecentFiles {
  public:
    /// `file` holds a path in each line; empty: nothing is kept.
    explicit RecentFiles(std::string file);

    /// It was opened, or saved; samples and presets are no files. Other editors' files are kept,
    /// too. A list that cannot be written is no reason to complain.
    void add(const std::string& path);
    /// Newest first, at most ten, absolute.
    const std::vector<std::string>& paths() const { return paths_; }

  private:
    void read();

    std::string file_;
    std::vector<std::string> paths_;
};

}  // namespace burl
