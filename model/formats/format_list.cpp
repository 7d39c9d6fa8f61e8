#include "model/formats/format_list.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <new>

#include "model/cad/brep_format.h"
#include "model/cad/iges_format.h"
#include "model/cad/step_format.h"
#include "model/files/file_replacement.h"
#include "model/formats/bpt_format.h"
#include "model/formats/knotspan_format.h"
#include "model/formats/loop_notes.h"
#include "model/formats/obj_format.h"
#include "model/formats/written_loops.h"
#include "model/mesh_files/mesh_formats.h"

namespace knotspan::formats {
namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{2} << 30;

std::string extensionOf(const fs::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension.empty() ? extension : extension.substr(1);
}

using Ability = bool (*)(const Format&);

std::string extensionsThat(Ability can)
{
    std::string list;
    for (const Format& format : all())
        if (can(format))
            for (const std::string& extension : format.extensions)
                list += (list.empty() ? "." : ", .") + extension;
    return list;
}

// The format, where it can do what is asked; `verb` is "read" or "write".
Result<const Format*> formatFor(const fs::path& path, const char* verb, Ability can)
{
    const std::string remedy = "Knotspan can " + std::string(verb) + " " + extensionsThat(can);
    const std::string extension = extensionOf(path);
    if (extension.empty())
        return failure("The name has no extension that tells the format", remedy);
    const Format* format = find(path);
    if (format == nullptr)
        return failure("Knotspan does not know the format ." + extension, remedy);
    if (!can(*format))
        return failure("Knotspan cannot " + std::string(verb) + " " + format->name + " files", remedy);
    return format;
}

Result<void> requireReadable(const fs::path& path)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found)
        return failure("There is no such file", "Check the name");
    if (error)
        return failure("The file cannot be reached: " + error.message(), "Check who may read it");
    if (fs::is_directory(status))
        return failure("This is a folder, not a file", "Choose a file in it");
    // A pipe or a device might never end.
    if (!fs::is_regular_file(status))
        return failure("This is no ordinary file", "Copy its content to a file first");
    if (auto opened = openedForReading(path); !opened)
        return opened;
    const std::uintmax_t size = fs::file_size(path, error);
    if (size == 0)
        return failure("The file is empty", "Choose another file");
    if (!error && size > kLargestFile)
        return failure("The file is larger than 2 GiB", "Split the model into several files");
    return {};
}

Result<Import> readUnnamed(const fs::path& path, const ImportWatch& watch)
{
    if (auto readable = requireReadable(path); !readable)
        return tl::unexpected(readable.error());
    const auto format = formatFor(path, "read", [](const Format& f) { return f.read != nullptr; });
    if (!format)
        return tl::unexpected(format.error());
    try {
        if (isReadApart(path))
            return importIsolated(path, watch, limitsFor(path));
        return (*format)->read(path);
    } catch (const std::bad_alloc&) {
        return failure("The model needs more memory than there is",
                       "Close other programs or split the model");
    }
}

Result<void> writeUnnamed(const Scene& scene, const fs::path& path)
{
    const auto format = formatFor(path, "write", [](const Format& f) { return f.write != nullptr; });
    if (!format)
        return tl::unexpected(format.error());
    try {
        return replaceFile(path, [&](const fs::path& temporary) {
            return (*format)->write((*format)->isOwn ? scene : withLoopsAsShown(scene), temporary);
        });
    } catch (const std::bad_alloc&) {
        return failure("Writing the model needs more memory than there is",
                       "Close other programs and try again");
    }
}

}  // namespace

const std::vector<Format>& all()
{
    static const std::vector<Format> list{
        knotspanFormat(), stepFormat(), igesFormat(), brepFormat(), objFormat(),  bptFormat(),
        stlFormat(),      plyFormat(),  offFormat(),  vtpFormat(),  gltfFormat(),
    };
    return list;
}

const Format* find(const fs::path& path)
{
    const std::string extension = extensionOf(path);
    for (const Format& format : all())
        if (std::find(format.extensions.begin(), format.extensions.end(), extension) !=
            format.extensions.end())
            return &format;
    return nullptr;
}

Result<Scene> read(const fs::path& path)
{
    return readWithNotes(path).map([](Import&& import) { return std::move(import.scene); });
}

Result<Import> readWithNotes(const fs::path& path, const ImportWatch& watch)
{
    const auto start = std::chrono::steady_clock::now();
    auto import =
        readUnnamed(path, watch).map_error([&](const Error& error) { return error.at(path.string()); });
    if (!import)
        return import;
    for (std::string& note : loopNotes(import->scene))
        import->notes.push_back(std::move(note));
    import->report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return import;
}

bool isReadApart(const fs::path& path)
{
    const Format* format = find(path);
    return format != nullptr && format->readIsolated != nullptr && !importWorker().empty();
}

Result<void> write(const Scene& scene, const fs::path& path)
{
    return writeUnnamed(scene, path).map_error([&](const Error& error) { return error.at(path.string()); });
}

}  // namespace knotspan::formats
