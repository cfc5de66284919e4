// machine.h - what a measurement was made on.
#pragma once

#include "bench/report/table.h"

#include <cstdint>
#include <string>

namespace firsthit::cli::bench {

struct Machine {
    std::string cpu; // "unknown" where the system does not say, as below
    unsigned cores = 0;
    std::uint64_t memory_bytes = 0;
    std::string system;          // kernel and its release
    std::string instruction_set; // of our kernels
    std::string date;            // UTC, ISO 8601
    std::string firsthit;        // version
    std::string commit;          // at configuration; "unknown" where there was no git
    std::string compiler;
    std::string build_type;
    std::string embree; // version at configuration, or "none"
    std::string opengl; // renderer and version, or why there is none
};

/// Asks system and OpenGL, of which a context is made once.
Machine describe_machine();

Json machine_json(const Machine& machine);
Table machine_table(const Machine& machine);

} // namespace firsthit::cli::bench
