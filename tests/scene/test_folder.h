// test_folder.h - an empty folder for one test, removed at its end.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace firsthit {

class TestFolder {
  public:
    TestFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "firsthit-XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~TestFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// Writes a file, and the folders above it; its path.
    std::filesystem::path write(const std::string& name, const std::string& bytes) const
    {
        const std::filesystem::path path = path_ / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }

  private:
    std::filesystem::path path_;
};

} // namespace firsthit
