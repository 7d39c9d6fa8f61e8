// The files that were open last, newest first, kept in the user's settings.
#pragma once

#include <filesystem>

#include <QStringList>

namespace knotspan::recentFiles {

[[nodiscard]] QStringList all();
void remember(const std::filesystem::path& path);
void forget(const QString& path);
void clear();

}  // namespace knotspan::recentFiles
