// report.h - what a benchmark found: for the page, for programs, for the terminal.
#pragma once

#include "bench/page.h"

#include <string>

namespace firsthit::cli::bench {

struct Report {
    Json json = Json::object(); // a member for each mode: "machine", "paper", "peers"
    Page page{"Firsthit: measured"};
    std::string text; // for the terminal

    /// To page and terminal.
    void add(const Table& table)
    {
        page.add(table);
        text += table_text(table) + "\n";
    }
};

/// With the folders that it is in, where it is missing. throws  FileError
void make_folder(const std::string& folder);

/// DIR/index.html and DIR/bench.json, each whole or not at all, in a folder that is there.
/// throws  FileError
void write_report(const Report& report, const std::string& folder);

} // namespace firsthit::cli::bench
