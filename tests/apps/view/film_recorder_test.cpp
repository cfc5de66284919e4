// film_recorder_test.cpp - a film of what is shown lasts as long as it was shown.
#include "view/frames/film_recorder.h"

#include "temporary_folder.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

namespace firsthit::cli::view {
namespace {

std::shared_ptr<const ShownFrame> grey_frame(int width, int height)
{
    auto frame = std::make_shared<ShownFrame>();
    frame->width = width;
    frame->height = height;
    frame->rgba.assign(std::size_t(width) * std::size_t(height) * 4, 128);
    return frame;
}

std::string output_of(const std::string& command)
{
    std::string text;
    std::FILE* pipe = popen(command.c_str(), "r");
    std::array<char, 256> part{};
    while (pipe && std::fgets(part.data(), int(part.size()), pipe)) text += part.data();
    if (pipe) pclose(pipe);
    return text;
}

TEST(FilmRecorder, LastsAsLongAsItWasShown)
{
    if (std::system("ffprobe -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg";
    const TemporaryFolder folder;
    const std::string path = folder / "film.mp4";
    FilmRecorder recorder(path, 64, 48);
    const Clock::time_point begin{std::chrono::hours(1)};
    const auto small = grey_frame(20, 10), large = grey_frame(64, 48);
    for (int ms = 0; ms < 2000; ms += 25)
        recorder.show(ms % 50 == 0 ? small : large, begin + std::chrono::milliseconds(ms));
    recorder.stop();
    while (!recorder.is_done()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_EQ(recorder.error(), "");
    EXPECT_EQ(output_of("ffprobe -v error -count_frames -select_streams v -show_entries "
                        "stream=width,height,nb_read_frames -of csv=p=0 " +
                        path),
        "64,48,60\n");
}

TEST(FilmRecorder, AFolderThatIsNotThereIsAnError)
{
    const TemporaryFolder folder;
    EXPECT_THROW(FilmRecorder(folder / "none/film.mp4", 64, 48), Error);
}

} // namespace
} // namespace firsthit::cli::view
