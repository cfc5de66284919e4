// sequence.h - numbered scene files as one animation.
#pragma once

#include <firsthit/scene.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace firsthit {

/// Options of reading a sequence.
struct SequenceSettings {
    static constexpr double kMinFps = 1e-6; // least value of fps
    static constexpr double kMaxFps = 1e6;  // greatest value of fps

    LoadSettings load{}; // of every file
    double fps = 24;     // by how much the files' numbers grow in a second
    /// Called once with every scene that was read, before anyone sees it, for example to replace its
    /// lights. May be called by the thread that reads ahead, but never twice at the same time. It
    /// must leave nodes, instances and vertices as they are.
    std::function<void(Scene&)> change{};
};

/// What reading all files of a sequence told.
struct SequenceSummary {
    std::array<std::size_t, 2> triangles{};  // least and most of a frame
    std::array<std::size_t, 2> vertices{};   // least and most of a frame
    std::array<glm::vec3, 2> bounds{};       // least and greatest coordinates of all frames
    std::vector<std::size_t> new_topology{}; // the frames, from 0, whose topology is not that of
                                             // the frame before them
};

/// Whether a name stands for numbered files: it has a %, it is no built-in, and no file has that very
/// name.
bool is_sequence_name(const std::string& name);

/// Numbered scene files (.obj .ply .stl .glb and so on), read as one animation of a frame for each
/// file. Frame k begins at (its file's number - the first file's number) / fps seconds; the last one
/// ends the clip. Files are read when they are needed, a thread reads the next one ahead, and few are
/// kept: memory does not grow with the number of files.
///
///     SceneSequence sequence("frames/%04d.obj", {.fps = 30});
///     for (double time_s = 0; time_s <= sequence.end_s(); time_s += 0.01) {
///         renderer.pose(sequence.scene_at(time_s), time_s, world);
///         renderer.render(world, view, settings, film);
///     }
///
/// Between two frames of the same topology, positions are interpolated linearly, and normals
/// linearly, then made unit. All else (materials, texture coordinates, colours, lights, cameras) is
/// the earlier frame's. Where the topology differs the earlier frame is shown until the later one's
/// time. Two frames have the same topology if the triangles of both join the same vertices of their
/// files, in the same order; in files that number no shared vertices (STL), if the same corners
/// coincide. Polygons may be cut into triangles in another way, and vertices be split at other
/// creases. A scene of a sequence
/// has one clip, the sequence's. A file with animations of its own is shown as its first clip begins.
///
/// Where numbers are missing, the frames on both sides of the gap are the neighbours in time; there
/// is a warning. A sequence of which no file has lights gets one, that of its first frame.
///
/// Several threads may share a sequence; one is served at a time.
class SceneSequence {
  public:
    static constexpr std::size_t kMaxFiles = 100'000; // most files of a sequence

    /// Lists the files and reads the first.
    ///
    /// name    numbered files (FilePattern), or all that load_scene takes, which is then shown at all
    ///         times: a program need not tell the two apart
    /// throws  ArgumentError: a wrong pattern or number of frames a second
    ///         FileError: no such files, too many, no folder; with `strict` also where numbers are
    ///         missing; and as load_scene for the first file
    explicit SceneSequence(const std::string& name, const SequenceSettings& settings = {});
    ~SceneSequence();
    /// The other one must not be used any more.
    SceneSequence(SceneSequence&&) noexcept;
    /// The other one must not be used any more.
    SceneSequence& operator=(SceneSequence&&) noexcept;

    /// Whether it is one of numbered files.
    bool is_numbered() const;

    /// The scene to pose at a time, before the first frame the first, after the last the last. It
    /// stays valid as long as it is held. The same pointer as before means that the same two
    /// frames are around that time. Scene::files are those of all frames.
    /// throws  ArgumentError: a time that is not finite
    ///         as load_scene, for a file that is needed now; the next call tries again
    std::shared_ptr<const Scene> scene_at(double time_s);

    /// Whether triangle ids and their corners mean the same at two times, so that a world of one may be
    /// Settings::previous of a frame of the other; vertices may be numbered in another way. So it is
    /// where the files of both times have one topology and cut polygons into the same triangles, and
    /// always of a single scene.
    /// throws  ArgumentError: a time that is not finite; and as scene_at
    bool same_triangles(double a_s, double b_s);

    /// The scene of one frame, as its file has it.
    /// throws  ArgumentError: there is no such frame; and as scene_at
    std::shared_ptr<const Scene> frame(std::size_t number);

    /// How many frames there are: files, or 1.
    std::size_t frames() const;

    /// Where a frame begins, seconds.
    double time_s(std::size_t number) const;

    /// Where the last frame begins, seconds; the first begins at 0. Of a single scene: where its first
    /// clip ends.
    double end_s() const;

    /// The file of a frame, or the scene's name.
    std::string file(std::size_t number) const;

    /// By how much numbers grow in a second.
    double fps() const;

    /// What is wrong with the sequence itself: missing numbers. Scene::warnings are of single files.
    const std::vector<std::string>& warnings() const;

    /// Reads all files.
    /// throws  as scene_at
    SequenceSummary summary();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace firsthit
