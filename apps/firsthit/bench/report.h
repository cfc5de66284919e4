// report.h - what a benchmark found: for the page, for programs, for the terminal.
#pragma once

#include "bench/page.h"

#include <filesystem>
#include <string>
#include <vector>

namespace firsthit::cli::bench {

struct Report {
    Json json = Json::object(); // a member for each mode: "machine", "paper", "baseline"
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

/// DIR/index.html and DIR/bench.json, each whole or not at all, in a folder that is there.
/// throws  FileError
void write_report(const Report& report, const std::string& folder);

} // namespace firsthit::cli::bench
