// coco_file.cpp - masks of pictures as one JSON file in the layout of the COCO data set.
#include "masks/coco_file.h"

#include <firsthit/render.h>

#include <utility>

namespace firsthit::cli {
namespace {

std::string on_one_line(const Json& json)
{
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// `"name": [`, an element on each line, `]`.
void add_list(std::string& text, const char* name, const Json& list)
{
    text += std::string(" \"") + name + "\": [";
    const char* separator = "\n  ";
    for (const Json& element : list) {
        text += separator + on_one_line(element);
        separator = ",\n  ";
    }
    text += "]";
}

} // namespace

CocoFile::CocoFile(std::string kind, bool compressed)
    : kind_(std::move(kind)),
      compressed_(compressed)
{
}

std::uint64_t CocoFile::category(const std::string& name)
{
    const auto [place, is_new] = category_number_.emplace(name, category_number_.size() + 1);
    if (is_new) categories_.push_back({{"id", place->second}, {"name", name}});
    return place->second;
}

void CocoFile::add(const MaskObjects& objects, const MaskedPicture& picture)
{
    // Categories do not depend on what is seen.
    for (std::size_t k = 0; k < objects.category.size(); ++k)
        if (!objects.instances[k].empty()) category(objects.category[k]);
    const std::uint64_t image = images_.size() + 1;
    Json hidden = Json::array();
    for (std::size_t k = 0; picture.alone && k < picture.alone->size(); ++k)
        if ((*picture.alone)[k] > 0 && !picture.masks.contains(std::uint32_t(k)))
            hidden.push_back(
                {{kind_, k}, {"name", objects.name[k]}, {"pixels_alone", (*picture.alone)[k]}});
    images_.push_back({{"id", image}, {"file_name", picture.file_name}, {"width", picture.width},
        {"height", picture.height}, {"time_s", picture.time_s}});
    if (picture.alone) images_.back()["hidden"] = std::move(hidden);
    for (const auto& [object, mask] : picture.masks) {
        Json counts = compressed_ ? Json(compressed_counts(mask.rle)) : Json(mask.rle.counts);
        Json entry = {{"id", annotations_.size() + 1}, {"image_id", image},
            {"category_id", category(objects.category[object])}, {"iscrowd", 0},
            {"area", mask.area}, {"bbox", {mask.x, mask.y, mask.box_width, mask.box_height}}};
        entry[kind_] = object;
        entry["name"] = objects.name[object];
        if (picture.alone) {
            const std::uint64_t alone = (*picture.alone)[object];
            entry["pixels_alone"] = alone;
            entry["visibility"] = double(mask.area) / double(alone);
        }
        entry["segmentation"] = {
            {"size", {mask.rle.height, mask.rle.width}}, {"counts", std::move(counts)}};
        annotations_.push_back(std::move(entry));
    }
}

std::string CocoFile::text(const std::string& scene) const
{
    const Json info = {{"description", scene}, {"version", version()}, {"objects", kind_}};
    std::string text = "{\n \"info\": " + on_one_line(info) + ",\n";
    add_list(text, "images", images_);
    text += ",\n";
    add_list(text, "categories", categories_);
    text += ",\n";
    add_list(text, "annotations", annotations_);
    return text + "\n}\n";
}

} // namespace firsthit::cli
