// fuzz_camera.cpp - files of cameras and paths of any bytes: they are read, or refused by a FileError. COLMAP's two
// files are one text with a line of === between them.
#include <firsthit/camera_file.h>
#include <firsthit/error.h>

#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace {

/// A folder for the files of this process.
struct Scratch {
    std::string path =
        (std::filesystem::temp_directory_path() / ("fuzz-camera-" + std::to_string(getpid())))
            .string();

    Scratch() { std::filesystem::create_directories(path); }
    ~Scratch()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    void write(const char* name, std::string_view bytes) const
    {
        std::ofstream(path + "/" + name, std::ios::binary) << bytes;
    }
};

void check(const firsthit::Camera& camera)
{
    for (int c = 0; c < 3; ++c)
        if (!std::isfinite(camera.eye[c]) || !std::isfinite(camera.direction[c])) std::abort();
}

void read_all(const std::string& path)
{
    try {
        for (const firsthit::FileCamera& camera : firsthit::read_cameras(path))
            check(firsthit::resized_camera(camera, 64, 48));
    } catch (const firsthit::FileError&) {
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const Scratch scratch;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    constexpr std::string_view kBetween = "\n===\n";
    if (const std::size_t middle = bytes.find(kBetween); middle != std::string_view::npos) {
        scratch.write("cameras.txt", bytes.substr(0, middle + 1));
        scratch.write("images.txt", bytes.substr(middle + kBetween.size()));
        read_all(scratch.path);
        return 0;
    }
    scratch.write("c.json", bytes);
    read_all(scratch.path + "/c.json");
    try {
        const firsthit::CameraPath path = firsthit::read_camera_path(scratch.path + "/c.json");
        for (const double time_s : {-1.0, 0.5, 1e9}) check(firsthit::camera_at(path, time_s));
    } catch (const firsthit::FileError&) {
    }
    return 0;
}
