// coco_file.h - masks of pictures as one JSON file in the layout of the COCO data set.
#pragma once

#include "common/json.h"
#include "masks/coco_rle.h"
#include "masks/mask_objects.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace firsthit::cli {

/// A picture whose masks are added.
struct MaskedPicture {
    std::string file_name; // of the picture that the masks belong to
    int width = 0;
    int height = 0;
    double time_s = 0;
    std::map<std::uint32_t, MaskShape> masks; // by object
    /// (objects) pixels that would see each if it was alone; absent: not counted
    std::optional<std::vector<std::uint64_t>> alone;
};

/// Puts {info, images, categories, annotations} together. Categories and annotations are numbered from
/// 1, images from 1 in the order in which they are added; category numbers are in the order in which
/// names first appear.
class CocoFile {
  public:
    /// kind  "instance", "node" or "material": the key of the object's number
    /// compressed  counts as text, which pycocotools writes; else as lists
    CocoFile(std::string kind, bool compressed);

    /// Adds a picture and what is seen in it. Objects that are behind others only are listed with the
    /// picture as `hidden`.
    void add(const MaskObjects& objects, const MaskedPicture& picture);

    /// A line for each picture, category and annotation.
    std::string text(const std::string& scene) const;

  private:
    std::uint64_t category(const std::string& name);

    std::string kind_;
    bool compressed_;
    Json images_ = Json::array();
    Json categories_ = Json::array();
    Json annotations_ = Json::array();
    std::map<std::string, std::uint64_t> category_number_;
};

} // namespace firsthit::cli
