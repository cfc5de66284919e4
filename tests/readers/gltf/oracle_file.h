// oracle_file.h - the JSON and the numbers of a glTF file, read slowly.
//
// Written from the specification alone: it shares nothing with the library.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace firsthit {

struct OracleFile {
    nlohmann::json root;
    std::vector<std::string> buffers; // the bytes of each

    /// Nothing where the file is damaged or uses what the oracle does not know: compressed buffers,
    /// instancing.
    static std::optional<OracleFile> open(const std::filesystem::path& path);

    /// Element by element. Columns of small matrices are not padded in what this oracle is used for.
    std::vector<std::vector<double>> accessor(std::size_t number) const;

  private:
    const char* view(std::size_t number, std::size_t& stride) const;
};

} // namespace firsthit
