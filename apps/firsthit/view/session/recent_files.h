// recent_files.h - which files were looked at last.
#pragma once

#include <string>
#include <vector>

namespace firsthit::cli::view {

/// Names of files, the latest first, at most kMost. They are kept from run to run in a file of their own, a name a
/// line; a list that cannot be read or written is no error.
class RecentFiles {
  public:
    static constexpr std::size_t kMost = 10;

    /// path  of the list; empty: it is kept for this run alone
    explicit RecentFiles(std::string path = {});

    /// Puts a file first, by its absolute name. Built-in scenes and standard input are none.
    void add(const std::string& file);

    const std::vector<std::string>& names() const { return names_; }

    /// $XDG_STATE_HOME/firsthit/recent, or ~/.local/state/firsthit/recent; empty where neither is known.
    static std::string usual_path();

  private:
    std::string path_;
    std::vector<std::string> names_;
};

} // namespace firsthit::cli::view
