// film_writer.cpp - a film, made by ffmpeg, that appears whole or not at all.
#include "films/film_writer.h"

#include "common/usage.h"

#include <firsthit/error.h>
#include <firsthit/file.h>

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

namespace firsthit::cli {
namespace {

std::string temporary_film(const std::string& target)
{
    const std::string name = fmt::format(".firsthit-{}-film.tmp", getpid());
    const std::filesystem::path folder = std::filesystem::path(target).parent_path();
    return ((folder.empty() ? "." : folder) / name).string();
}

/// Films of half as many samples of colour need two pixels at least.
void check_film_size(const std::string& path, const FilmSize& size)
{
    if (size.width >= 2 && size.height >= 2) return;
    throw UsageError(fmt::format("{}: a film of {}x{} pixels is too small: at least 2x2 are needed",
        path, size.width, size.height));
}

} // namespace

void check_film(const std::string& path)
{
    if (!is_installed("ffmpeg"))
        throw DeviceError(fmt::format(
            "{}: cannot write: films need the program ffmpeg, which is not installed (Debian and "
            "Ubuntu: apt-get install ffmpeg). Without it, write numbered pictures: {}_%04d.png",
            path, std::filesystem::path(path).stem().string()));
    check_output_path(path);
}

FilmWriter::FilmWriter(const std::string& path, const FilmSize& size)
    : path_(path),
      target_(output_target(path))
{
    check_film_size(path, size);
    check_film(path);
    temporary_ = temporary_film(target_);
    unlink(temporary_.c_str()); // of a process of our number that was killed
    ffmpeg_.emplace(ffmpeg_words(path, temporary_, size));
}

FilmWriter::~FilmWriter()
{
    ffmpeg_.reset(); // which ends it before its file goes
    if (!temporary_.empty()) unlink(temporary_.c_str());
}

void FilmWriter::add(std::span<const std::uint8_t> pixels)
{
    if (ffmpeg_->write(pixels.data(), pixels.size())) return;
    const std::string why = ffmpeg_->finish();
    fail(why.empty() ? "it reads no more" : why);
}

void FilmWriter::finish()
{
    const std::string why = ffmpeg_->finish();
    if (!why.empty()) fail(why);
    ffmpeg_.reset();
    struct stat kept {};
    if (stat(target_.c_str(), &kept) == 0) // a file that is replaced keeps its permissions
        (void)chmod(temporary_.c_str(), kept.st_mode & 0777);
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0)
        throw FileError(
            fmt::format("{}: cannot write: {}", path_, std::generic_category().message(errno)));
    temporary_.clear();
}

void FilmWriter::fail(const std::string& why)
{
    std::string words = why;
    const std::string hidden = "file:" + temporary_; // names the user never gave
    for (const std::string& name : {hidden, temporary_})
        for (std::size_t at; (at = words.find(name)) != std::string::npos;)
            words.replace(at, name.size(), path_);
    std::replace(words.begin(), words.end(), '\n', ' ');
    throw FileError(fmt::format("{}: cannot write: ffmpeg failed: {}", path_, words));
}

} // namespace firsthit::cli
