// picture_cache.h - pictures that were decoded for the last frames of a sequence, found again by their bytes.
#pragma once

#include <firsthit/texture.h>

#include <array>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <span>
#include <string>

namespace firsthit {

/// Keeps the pictures of the scenes that were read last, so that frames with the same textures decode them once,
/// whatever their files' names are. Several threads may share one.
class PictureCache {
  public:
    /// Scenes without a picture before it is let go. Two that are read at the same time may end in any order.
    static constexpr std::size_t kKept = 3;

    /// While it lives, decode_picture on this thread asks the cache first.
    class Use {
      public:
        explicit Use(PictureCache& cache);
        ~Use();
        Use(const Use&) = delete;
        Use& operator=(const Use&) = delete;

      private:
        PictureCache* before_;
    };

    /// The cache of this thread; null where there is none.
    static PictureCache* current();

    /// The picture of a file with the same bytes; null where there is none.
    std::shared_ptr<const Picture> find(std::span<const char> bytes);

    void add(std::span<const char> bytes, const Picture& picture);

    /// The same for textures with all their levels, which take longer to make than pictures.
    std::shared_ptr<const Texture> find_texture(std::span<const char> bytes, Encoding encoding);

    void add_texture(std::span<const char> bytes, Encoding encoding, const Texture& texture);

    /// How many there are.
    std::size_t size();

  private:
    struct Entry {
        std::size_t hash = 0;
        std::string bytes;                      // of the file: equal hashes are no proof
        std::shared_ptr<const Picture> picture; // null: was not asked for
        std::array<std::shared_ptr<const Texture>, 2> texture; // by encoding; null: as above
        std::size_t scene = 0;                                 // the last one that used it
    };
    void begin_scene();
    Entry* known_entry(std::span<const char> bytes);
    Entry& entry_of(std::span<const char> bytes);

    std::mutex use_;
    std::list<Entry> entries_;
    std::size_t scene_ = 0; // that is read
};

} // namespace firsthit
