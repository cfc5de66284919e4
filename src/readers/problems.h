// problems.h - what is wrong in a file and was left out or repaired, a warning for each kind of it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit {

/// Counts problems by kind and keeps the first place of each, so that a file with a million of one kind
/// makes one line.
class Problems {
  public:
    /// Counts one more of a kind.
    /// kind    what it is and what was done: "normals that do not exist are computed"
    /// what    where the first one is: "line", "vertex", "face"; empty: nowhere in particular
    /// number  of the line, vertex or face
    void add(std::string_view kind, std::string_view what = {}, std::size_t number = 0);

    /// Counts `times` more at once, of which the first is at that place; nothing for 0.
    void add_times(std::string_view kind, std::size_t times, std::string_view what = {},
        std::size_t number = 0);

    bool empty() const { return kinds_.empty(); }

    /// One line a kind, in order of their first places: "NAME: KIND (first at line 7, 3 times)".
    std::vector<std::string> lines(const std::string& name) const;

  private:
    struct Kind {
        std::string text;
        std::string place; // empty: nowhere in particular
        std::size_t count = 0;
    };
    std::vector<Kind> kinds_;
    std::size_t last_ = 0; // of kinds_: what was added last is often what comes next
};

} // namespace firsthit
