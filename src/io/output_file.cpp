// output_file.cpp - a file that appears whole or not at all.
#include "io/output_file.h"

#include "io/file_identity.h"

#include <firsthit/error.h>
#include <firsthit/file.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

namespace firsthit {

namespace fs = std::filesystem;

namespace {

std::string folder_of(const std::string& path)
{
    const std::string folder = fs::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

std::string reason(const std::string& target, int error)
{
    if (error == ENOENT) return fmt::format("the folder '{}' does not exist", folder_of(target));
    return std::generic_category().message(error);
}

[[noreturn]] void throw_cannot_write(const std::string& path, const std::string& target, int error)
{
    if (is_standard_output(path))
        throw FileError(fmt::format(
            "standard output: cannot write: {}", std::generic_category().message(error)));
    throw FileError(fmt::format("{}: cannot write: {}", path, reason(target, error)));
}

/// Writes all bytes. Returns 0, or the reason of a failure.
int write_all(int descriptor, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return written < 0 ? errno : EIO;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

/// A name that no other process of this machine, nor thread, uses. It does not grow with the target's name, which may
/// be as long as names can be.
std::string temporary_name(const std::string& target)
{
    static std::atomic<unsigned> counter{0};
    const std::string name = fmt::format(".firsthit-{}-{}.tmp", getpid(), counter++);
    return (fs::path(target).parent_path() / name).string();
}

/// How many temporary names are tried.
constexpr int kMostNames = 10'000;

/// The permissions of a file that is there, nothing of one that is not.
std::optional<mode_t> permissions_of(const std::string& path)
{
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) return std::nullopt;
    return status.st_mode & 0777;
}

} // namespace

bool is_device(const std::string& path)
{
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void check_output_path(const std::string& path)
{
    if (is_standard_output(path)) return;
    if (path.empty()) throw FileError("cannot write to a file without a name");
    const std::string target = follow_links(path);
    std::error_code ignored;
    if (fs::is_directory(target, ignored)) throw_cannot_write(path, target, EISDIR);
    const bool exists = fs::exists(target, ignored);
    // Links are followed as far as they lead.
    if (!exists && fs::is_symlink(target, ignored)) throw_cannot_write(path, target, ELOOP);
    if (exists && access(target.c_str(), W_OK) != 0) throw_cannot_write(path, target, errno);
    if (exists && is_device(target)) return;
    const std::string folder = folder_of(target);
    if (fs::exists(folder, ignored) && !fs::is_directory(folder, ignored))
        throw_cannot_write(path, target, ENOTDIR);
    if (access(folder.c_str(), W_OK | X_OK) != 0) throw_cannot_write(path, target, errno);
}

void write_file(const std::string& path, std::string_view bytes)
{
    OutputFile file(path);
    file.write(bytes.data(), bytes.size());
    file.commit();
}

OutputFile::OutputFile(const std::string& path)
    : path_(path),
      target_(is_standard_output(path) ? path : follow_links(path)),
      standard_(is_standard_output(path))
{
    if (standard_) return;
    check_output_path(path);
    int descriptor = -1;
    if (is_device(target_)) {
        descriptor = open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    } else {
        // What nobody else may read is at no time open to others.
        const std::optional<mode_t> kept = permissions_of(target_);
        // On a shared disk, names may be those of another machine's process, or of one that was killed.
        for (int attempt = 0; descriptor < 0 && attempt < kMostNames; ++attempt) {
            temporary_ = temporary_name(target_);
            descriptor = open(
                temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kept.value_or(0666));
            if (descriptor < 0 && errno != EEXIST) break;
        }
        if (descriptor < 0) temporary_.clear();
        // Some file systems have no permissions to keep; the bytes matter more.
        else if (kept && fchmod(descriptor, *kept) != 0)
            errno = 0;
    }
    if (descriptor < 0) fail(errno);
    file_ = fdopen(descriptor, "wb");
    if (!file_) {
        const int error = errno;
        close(descriptor);
        fail(error);
    }
}

OutputFile::~OutputFile()
{
    discard();
}

void OutputFile::write(const void* data, std::size_t bytes)
{
    if (standard_ && !error_) {
        if (bytes == 0) return;
        if (bytes_.size() < place_ + bytes) bytes_.resize(place_ + bytes);
        std::memcpy(bytes_.data() + place_, data, bytes);
        place_ += bytes;
        return;
    }
    // Nothing may be null, which fwrite does not accept.
    if (error_ || (bytes > 0 && std::fwrite(data, 1, bytes, file_) != bytes)) fail(errno);
}

void OutputFile::seek(std::uint64_t offset)
{
    if (standard_ && !error_) {
        place_ = static_cast<std::size_t>(offset);
        return;
    }
    if (error_ || fseeko(file_, static_cast<off_t>(offset), SEEK_SET) != 0) fail(errno);
}

std::uint64_t OutputFile::tell()
{
    if (standard_ && !error_) return place_;
    const off_t offset = error_ ? -1 : ftello(file_);
    if (offset < 0) fail(errno);
    return static_cast<std::uint64_t>(offset);
}

void OutputFile::commit()
{
    if (standard_ && !error_) {
        std::fflush(stdout); // what was printed before comes before
        const int error = write_all(STDOUT_FILENO, bytes_);
        if (error) fail(error);
        bytes_.clear();
        place_ = 0;
        return;
    }
    if (error_ || std::fflush(file_) != 0) fail(errno);
    std::FILE* file = file_;
    file_ = nullptr;
    if (std::fclose(file) != 0) fail(errno);
    if (temporary_.empty()) return;
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
    temporary_.clear();
}

void OutputFile::fail(int error)
{
    if (!error_) error_ = error ? error : EIO;
    discard();
    throw_cannot_write(path_, target_, error_);
}

void OutputFile::discard()
{
    if (file_) std::fclose(file_);
    file_ = nullptr;
    if (!temporary_.empty()) unlink(temporary_.c_str());
    temporary_.clear();
}

} // namespace firsthit
