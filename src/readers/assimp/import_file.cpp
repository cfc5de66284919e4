// import_file.cpp - a file's bytes through Assimp.
#include "readers/assimp/import_file.h"

#include "readers/assimp/dae_numbers.h"
#include "readers/assimp/try_in_child.h"
#include "readers/assimp/utf8.h"

#include <firsthit/error.h>

#include <assimp/BaseImporter.h>
#include <assimp/IOSystem.hpp>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <new>
#include <sstream>
#include <string_view>
#include <vector>

namespace firsthit {
namespace {

/// A folder with nothing in it: whatever a file asks for is missing.
class NoFiles : public Assimp::IOSystem {
  public:
    bool Exists(const char*) const override { return false; }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
    void Close(Assimp::IOStream*) override {}
};

/// Takes all readers away but those of one ending, so that a file's content cannot choose another.
void keep_readers_of(Assimp::Importer& importer, const std::string& ending)
{
    std::vector<std::size_t> others;
    for (std::size_t k = 0; k < importer.GetImporterCount(); ++k) {
        std::istringstream endings(importer.GetImporterInfo(k)->mFileExtensions);
        bool reads = false;
        for (std::string word; endings >> word;) reads = reads || word == ending;
        if (!reads) others.push_back(k);
    }
    std::vector<Assimp::BaseImporter*> readers;
    for (const std::size_t k : others) readers.push_back(importer.GetImporter(k));
    for (Assimp::BaseImporter* reader : readers) {
        importer.UnregisterLoader(reader);
        delete reader; // which UnregisterLoader leaves to its caller
    }
}

/// The first line of what Assimp says. It may quote the file, and calls it by a name of its own.
std::string reason_of(const std::string& why)
{
    constexpr std::size_t kLongest = 200;
    constexpr std::string_view kOwn = AI_MEMORYIO_MAGIC_FILENAME;
    std::string_view rest(why);
    rest = rest.substr(0, std::min(rest.find_first_of("\r\n"), kLongest));
    std::string line;
    while (!rest.empty()) {
        const bool own = rest.starts_with(kOwn);
        const char c = own ? '*' : rest.front();
        line += ' ' <= c && c <= '~' ? c : '?';
        rest.remove_prefix(own ? kOwn.size() : 1);
    }
    return line.empty() ? "Assimp gives no reason" : line;
}

constexpr unsigned kSteps = aiProcess_ValidateDataStructure | aiProcess_Triangulate |
                            aiProcess_SortByPType | aiProcess_JoinIdenticalVertices |
                            aiProcess_GenSmoothNormals | aiProcess_LimitBoneWeights |
                            aiProcess_TransformUVCoords | aiProcess_FindInvalidData;

/// why  set to what Assimp says where there is no scene
ImportedFile import_text(const std::string& text, const std::string& extension,
    double crease_angle_rad, std::string& why)
{
    ImportedFile file;
    try {
        file.importer = std::make_unique<Assimp::Importer>();
        Assimp::Importer& importer = *file.importer;
        importer.SetIOHandler(new NoFiles); // the importer deletes it
        const std::string ending = extension.substr(std::min<std::size_t>(1, extension.size()));
        keep_readers_of(importer, ending);
        constexpr double kDegrees = 180 / 3.14159265358979323846;
        importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE,
            static_cast<float>(std::clamp(crease_angle_rad * kDegrees, 0.0, 175.0)));
        importer.SetPropertyInteger(
            AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
        importer.SetPropertyInteger(AI_CONFIG_PP_LBW_MAX_WEIGHTS, 8);
        file.scene = importer.ReadFileFromMemory(text.data(), text.size(), kSteps, ending.c_str());
        why = importer.GetErrorString();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        why = error.what();
    }
    return file;
}

} // namespace

ImportedFile import_file(const std::string& name, const std::string& bytes,
    const std::string& extension, double crease_angle_rad)
{
    if (bytes.empty()) throw FileError(fmt::format("{}: the file is empty", name));
    // Assimp 5.2 takes XML for UTF-8, whatever it says.
    const std::string xml =
        extension == ".dae" ? without_blanks_before_numbers(as_utf8(bytes)) : std::string();
    const std::string& text = extension == ".dae" ? xml : bytes;
    std::string why;
    const auto import = [&] { return import_text(text, extension, crease_angle_rad, why); };
    try_in_child(name, text.size(), [&] {
        try {
            (void)import();
        } catch (const std::bad_alloc&) {
            return false;
        } catch (const std::exception&) {
            // The second time says why.
        }
        return why.find("bad_alloc") == std::string::npos; // Assimp hands it on as a text
    });
    ImportedFile file = import();
    if (!file.scene || !file.scene->mRootNode)
        throw FileError(fmt::format("{}: cannot be read: {}", name, reason_of(why)));
    return file;
}

} // namespace firsthit
