// table.cpp - a table for the page and for the terminal.
#include "bench/report/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace firsthit::cli::bench {

namespace {

std::string plain(const Cell& cell)
{
    if (cell.note.empty()) return cell.text;
    return cell.text.empty() ? cell.note : cell.text + " (" + cell.note + ")";
}

/// How many columns of a terminal it takes: characters, not bytes.
std::size_t length(const std::string& utf8)
{
    return std::size_t(std::count_if(utf8.begin(), utf8.end(),
        [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string spaces(std::size_t count)
{
    return std::string(count, ' ');
}

} // namespace

std::string number_text(double value)
{
    if (!std::isfinite(value)) return "-";
    const double size = std::abs(value);
    if (size == 0) return "0";
    if (size < 0.001 || size >= 1e9) return fmt::format("{:.2e}", value);
    const int digits = std::max(0, 2 - static_cast<int>(std::floor(std::log10(size))));
    return fmt::format("{:.{}f}", value, digits);
}

Cell cell(const Quartiles& values)
{
    if (values.count == 0) return {"-"};
    return {
        number_text(values.median), number_text(values.lower) + " to " + number_text(values.upper)};
}

Cell missing_cell(const std::string& reason)
{
    return {"-", reason};
}

std::string table_text(const Table& table)
{
    std::vector<std::size_t> width(table.head.size(), 0);
    for (std::size_t k = 0; k < width.size(); ++k) {
        width[k] = length(table.head[k]);
        for (const auto& row : table.rows)
            if (k < row.size()) width[k] = std::max(width[k], length(plain(row[k])));
    }
    const auto padded = [&](const std::string& text, std::size_t column) {
        const std::string room = spaces(width[column] - length(text));
        return column == 0 ? text + room : "  " + room + text;
    };
    std::string text = table.title + "\n";
    for (std::size_t k = 0; k < width.size(); ++k) text += padded(table.head[k], k);
    text += '\n';
    for (const auto& row : table.rows) {
        for (std::size_t k = 0; k < std::min(row.size(), width.size()); ++k)
            text += padded(plain(row[k]), k);
        text += '\n';
    }
    return text;
}

} // namespace firsthit::cli::bench
