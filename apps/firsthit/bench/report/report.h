// report.h - what a benchmark found: for the page, for programs, for the terminal.
#pragma once

#include "bench/report/page.h"

#include <filesystem>
#include <string>
#include <vector>

namespace firsthit::cli::bench {

struct Report {
    Json json = Json::object(); // a member for each mode, beside "machine", "quick" and "page"
    Page page{"Firsthit: measured"};
    std::string text; // for the terminal

    /// To page and terminal.
    void add(const Table& table)
    {
        page.add(table);
        text += table_text(table) + "\n";
    }
};

/// A folder for what will be written later: made now, where it is missing, and gone again if nothing was.
class ReportFolder {
  public:
    /// path  empty: no folder
    /// throws  FileError: it cannot be made
    explicit ReportFolder(std::string path);
    ~ReportFolder();
    ReportFolder(const ReportFolder&) = delete;
    ReportFolder& operator=(const ReportFolder&) = delete;

    const std::string& path() const { return path_; }

  private:
    void remove_empty();

    std::string path_;
    std::vector<std::filesystem::path> made_; // the outermost first
};

/// DIR/bench.json, the page's pictures, and DIR/index.html drawn from these, each whole or not at all, in a
/// folder that is there. Where the page cannot be drawn, DIR/report.py is written too, which draws it elsewhere.
/// returns  a warning, which says why there is no page; empty: there is one
/// throws   FileError
std::string write_report(const Report& report, const std::string& folder);

} // namespace firsthit::cli::bench
