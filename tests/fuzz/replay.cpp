// replay.cpp - a fuzz target without libFuzzer: runs it on every file named, whole, cut off after
// each byte, and with each byte replaced. Usage: fuzz_NAME FILE...
#include "io/whole_file.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

constexpr std::uintmax_t kMaxBytes = 1 << 20; // of a file

std::size_t runs = 0;

void run(std::string_view bytes)
{
    // Of its own size on the heap: the sanitizers see what reads past the end.
    const std::string copy(bytes);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(copy.data()), copy.size());
    ++runs;
}

void replay(std::string bytes)
{
    constexpr std::array kReplacements = {'\0', '\xff', '\x80', ' ', '-', '9', 'e', '#'};
    for (std::size_t n = 0; n <= bytes.size(); ++n) run(std::string_view(bytes).substr(0, n));
    for (char& byte : bytes) {
        const char sound = byte;
        for (const char other : kReplacements) {
            byte = other;
            run(bytes);
        }
        byte = sound;
    }
}

} // namespace

int main(int argc, char** argv)
{
    try {
        for (int k = 1; k < argc; ++k) replay(firsthit::read_whole_file(argv[k], kMaxBytes));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
        return 1;
    }
    std::printf("%zu inputs\n", runs);
    return runs == 0;
}
