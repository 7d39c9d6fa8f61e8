// Small pictures of models: of files, as they were shown last, kept in the user's cache; of the samples.
#pragma once

#include <filesystem>

#include <QImage>

namespace knotspan::modelPictures {

constexpr QSize kSize{320, 200};

// What was kept of the file; null where nothing was, or where the file was written since.
[[nodiscard]] QImage of(const std::filesystem::path& file);
// The same without reading the picture.
[[nodiscard]] bool isKept(const std::filesystem::path& file);
// Cuts the picture to kSize and keeps it; what was kept of files that are not recent goes. From any thread.
void keep(const std::filesystem::path& file, const QImage& picture);

[[nodiscard]] QImage ofSample(const std::string& name);

}  // namespace knotspan::modelPictures
