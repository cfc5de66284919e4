// output_file.h - a file that appears whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

namespace firsthit {

/// Writes beside `path` under a temporary name; commit() renames it into place. Without a commit,
/// nothing is left. A file that is replaced keeps its permissions. A symbolic link is followed, also
/// to a file that is not there yet. What exists and is no regular file (/dev/null, a pipe) is written
/// directly. "-" is standard output: what is written there waits in memory for the commit.
///
/// Where the process ignores SIGXFSZ, a limit on the size of files is an error as others are; it ends
/// the process otherwise, and the temporary name stays.
///
/// throws  FileError that names the path and the reason, from every function
class OutputFile {
  public:
    explicit OutputFile(const std::string& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(const void* data, std::size_t bytes);
    void seek(std::uint64_t offset);
    std::uint64_t tell();

    /// Throws also what an earlier write threw, in case a library in between swallowed it.
    void commit();

    /// True after any function has thrown.
    bool failed() const { return error_ != 0; }

    const std::string& path() const { return path_; }

  private:
    [[noreturn]] void fail(int error);
    void discard();

    std::string path_;      // as given, for messages
    std::string target_;    // where it goes, links resolved
    std::string temporary_; // empty where the target is written directly
    std::FILE* file_ = nullptr;
    bool standard_ = false; // standard output: bytes_ are written at the end
    std::string bytes_;
    std::size_t place_ = 0; // in bytes_
    int error_ = 0;         // errno of the first failure
};

/// Whether a path stands for standard output.
inline bool is_standard_output(const std::string& path)
{
    return path == "-";
}

/// True where `path` exists and is neither a regular file nor a folder.
bool is_device(const std::string& path);

} // namespace firsthit
