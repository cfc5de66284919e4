// table.h - a table for the page and for the terminal.
#pragma once

#include "bench/measure/quartiles.h"

#include <string>
#include <vector>

namespace firsthit::cli::bench {

/// Text, and beneath it, smaller, what qualifies it: quartiles, the paper's number, a reason.
struct Cell {
    std::string text;
    std::string note = {};
};

/// Rows are as long as the head. The first column is read as names, the others as numbers.
struct Table {
    std::string title;
    std::vector<std::string> head;
    std::vector<std::vector<Cell>> rows;
    std::string note; // below the table, one paragraph; may be empty
};

/// Three significant digits, without an exponent from 0.001 to 10^9: "0.0123", "4.56", "78.9", "1234".
std::string number_text(double value);

/// The median, and the quartiles as its note.
Cell cell(const Quartiles& values);

/// A number that is missing, and why.
Cell missing_cell(const std::string& reason);

/// Columns for a terminal, notes in brackets.
std::string table_text(const Table& table);

} // namespace firsthit::cli::bench
