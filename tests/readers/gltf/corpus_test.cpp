// corpus_test.cpp - files that others made: valid ones are read, of no other one anything crashes.
#include "readers/gltf/document/document.h"
#include "readers/gltf/data/images.h"
#include "test_data.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <string>

namespace firsthit::gltf {
namespace {

namespace fs = std::filesystem;

/// Reads all that a document holds.
/// returns  why it was refused; empty: it was not
std::string read_all(const fs::path& path)
{
    try {
        const Document document = read_document(path);
        for (std::size_t k = 0; k < document.accessors.size(); ++k) {
            try {
                read_floats(document, static_cast<int>(k), document.accessors[k].components());
            } catch (const Error&) { // its bytes are missing
            }
        }
        for (std::size_t k = 0; k < document.images.size(); ++k)
            decode_image(document, static_cast<int>(k));
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

bool is_valid(const fs::path& report)
{
    const auto json = nlohmann::json::parse(std::ifstream(report));
    return json["issues"]["numErrors"] == 0;
}

TEST(GltfCorpus, EveryFileThatTheValidatorAcceptsIsRead)
{
    int files = 0, valid = 0;
    for (const char* name : {"corpus/gltf", "gltf"}) {
        const std::optional<fs::path> folder = test_data(name);
        if (!folder) continue;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(*folder)) {
            const fs::path& path = entry.path();
            if (path.extension() != ".gltf" && path.extension() != ".glb") continue;
            const std::string refused = read_all(path);
            ++files;
            const fs::path report = path.string() + ".report.json";
            if (!fs::exists(report) || !is_valid(report)) continue;
            ++valid;
            EXPECT_EQ(refused, "");
        }
    }
    if (files == 0) GTEST_SKIP() << "no files: set FIRSTHIT_TEST_DATA";
    RecordProperty("files", files);
    RecordProperty("valid", valid);
}

} // namespace
} // namespace firsthit::gltf
