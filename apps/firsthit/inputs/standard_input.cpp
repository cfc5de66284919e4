// standard_input.cpp - a scene that comes through standard input.
#include "inputs/standard_input.h"

#include "common/interrupt.h"
#include "common/usage.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

namespace firsthit::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::array kFormats = {
    "gltf", "glb", "fbx", "dae", "3mf", "aff", "nff", "ply", "stl", "obj", "off"};
constexpr std::uint64_t kMostBytes = std::uint64_t(1) << 32; // as of files

/// A folder that goes when it is no longer needed.
class ScratchFolder {
  public:
    ScratchFolder()
    {
        std::error_code ignored;
        std::string pattern = (fs::temp_directory_path(ignored) / "firsthit-XXXXXX").string();
        if (!mkdtemp(pattern.data()))
            throw FileError(fmt::format("{}: cannot make a folder to keep standard input in: {}",
                pattern, std::generic_category().message(errno)));
        path_ = pattern;
    }
    ~ScratchFolder()
    {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

void copy_standard_input(const fs::path& path)
{
    std::ofstream file(path, std::ios::binary);
    std::vector<char> buffer(std::size_t(1) << 18);
    std::uint64_t bytes = 0;
    for (;;) {
        const ssize_t got = read(STDIN_FILENO, buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0)
            throw FileError(fmt::format(
                "{}: cannot be read: {}", kStandardInput, std::generic_category().message(errno)));
        if (got == 0) break;
        bytes += static_cast<std::uint64_t>(got);
        if (bytes > kMostBytes)
            throw FileError(fmt::format(
                "{}: more than {} bytes, which are accepted", kStandardInput, kMostBytes));
        file.write(buffer.data(), got);
        if (!file) break;
    }
    file.close();
    if (!file)
        throw FileError(
            fmt::format("{}: cannot write what came from standard input: no space in {}",
                path.string(), path.parent_path().parent_path().string()));
    if (bytes == 0) throw FileError(fmt::format("{}: it is empty", kStandardInput));
}

std::string without_name(std::string text, const std::string& name)
{
    for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos;)
        text.replace(at, name.size(), kStandardInput);
    return text;
}

} // namespace

std::string parse_scene_format(const std::string& text)
{
    std::string list;
    for (const char* format : kFormats) {
        if (text == format) return "." + text;
        list += (list.empty() ? "" : ", ") + std::string(format);
    }
    throw UsageError(fmt::format("'{}' is no format of scenes: accepted are {}", text, list));
}

SceneSequence read_standard_input(const std::string& ending, SequenceSettings settings)
{
    const HoldInterrupts hold; // so that nothing is left in the folder for temporary files
    const ScratchFolder folder;
    const std::string path = (folder.path() / ("scene" + ending)).string();
    copy_standard_input(path);
    settings.change = [path, change = std::move(settings.change)](Scene& scene) {
        scene.name = without_name(scene.name, path);
        for (std::string& warning : scene.warnings) warning = without_name(warning, path);
        std::erase(scene.files, path);
        if (change) change(scene);
    };
    try {
        return SceneSequence(path, settings);
    } catch (const FileError& error) {
        throw FileError(without_name(error.what(), path));
    } catch (const SceneError& error) {
        throw SceneError(without_name(error.what(), path));
    }
}

} // namespace firsthit::cli
