// scene_source.h - the scene of each time: a single file, or a sequence of them.
#pragma once

#include "options/scene_options.h"

#include <firsthit/sequence.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace firsthit::cli {

/// A scene or sequence; nothing is printed.
/// change  as SequenceSettings::change
/// throws  as SceneSequence; UsageError: --fps with a single scene
SceneSequence open_scene(const SceneOptions& options, std::function<void(Scene&)> change = {});

/// Prints warnings about files to stderr. Of a sequence a warning is printed once where frames differ in
/// nothing but numbers, and how many others there were at the end of its life.
class WarningPrinter {
  public:
    ~WarningPrinter();

    void print(const std::vector<std::string>& warnings);

  private:
    std::set<std::string> texts_; // of all warnings
    std::set<std::string> kinds_; // the same without digits
};

/// A scene or sequence, whose warnings are printed as they come.
class SceneSource {
  public:
    /// change  as SequenceSettings::change
    /// throws  as SceneSequence; UsageError: --fps with a single scene
    explicit SceneSource(const SceneOptions& options, std::function<void(Scene&)> change = {});

    /// As SceneSequence::scene_at.
    std::shared_ptr<const Scene> scene_at(double time_s);

    /// The first frame's scene.
    std::shared_ptr<const Scene> first() { return told(sequence_.frame(0)); }

    SceneSequence& sequence() { return sequence_; }

  private:
    /// Prints the warnings of a scene that was not the last one.
    std::shared_ptr<const Scene> told(std::shared_ptr<const Scene> scene);

    SceneSequence sequence_;
    std::shared_ptr<const Scene> last_;
    WarningPrinter warnings_;
};

} // namespace firsthit::cli
