#include "tests/corpus/corpora.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <optional>
#include <random>

#include "model/formats/format_list.h"
#include "tests/support.h"

namespace knotspan::corpus {
namespace fs = std::filesystem;

namespace {

struct Place {
    const char* name;
    const char* folder;
};

// Where the packages put what they bring; the largest is the last.
constexpr Place kPackages[] = {
    {"gmsh-doc", "/usr/share/doc/gmsh-doc"},
    {"calculix-cgx-examples", "/usr/share/doc/calculix-cgx-examples"},
    {"freecad-common", "/usr/share/freecad"},
    {"kicad-demos", "/usr/share/kicad/demos"},
    {"kicad-packages3d", "/usr/share/kicad/3dmodels"},
};

std::string extensionOf(const fs::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

bool isReadable(const fs::path& path)
{
    const formats::Format* format = formats::find(path);
    return format != nullptr && (format->read != nullptr || format->readIsolated != nullptr);
}

std::string quoted(const fs::path& path)
{
    std::string text = "'";
    for (const char c : path.string())
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

bool succeeds(const std::string& command)
{
    return std::system((command + " 2>/dev/null").c_str()) == 0;
}

std::vector<fs::path> filesBelow(const fs::path& folder)
{
    std::vector<fs::path> files;
    std::error_code error;
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator at(folder, options, error), end; at != end; at.increment(error)) {
        if (error)
            break;
        if (at->is_regular_file(error))
            files.push_back(at->path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

class Collector {
public:
    Collector(std::string name, const fs::path& folder, fs::path scratch)
        : corpus_{std::move(name), {}},
          scratch_(std::move(scratch))
    {
        for (const fs::path& file : filesBelow(folder))
            take(file, file.lexically_relative(folder).string());
    }

    [[nodiscard]] Corpus corpus() && { return std::move(corpus_); }

private:
    void take(const fs::path& file, const std::string& name)
    {
        const std::string extension = extensionOf(file);
        if (extension == ".gz" && isReadable(file.stem()))
            takeCompressed(file, name);
        else if (extension == ".fcstd")
            takeArchive(file, name);
        else if (isReadable(file))
            corpus_.files.push_back({corpus_.name, name, file});
    }

    [[nodiscard]] fs::path nextFolder()
    {
        const fs::path folder = scratch_ / corpus_.name / std::to_string(unpacked_++);
        fs::create_directories(folder);
        return folder;
    }

    void takeCompressed(const fs::path& file, const std::string& name)
    {
        const fs::path plain = nextFolder() / file.stem();
        if (succeeds("gzip -dc " + quoted(file) + " > " + quoted(plain)))
            corpus_.files.push_back({corpus_.name, name, plain});
    }

    // FreeCAD's documents are zip archives with a BREP file for each shape.
    void takeArchive(const fs::path& file, const std::string& name)
    {
        const fs::path folder = nextFolder();
        static_cast<void>(succeeds("unzip -qq -o " + quoted(file) + " -d " + quoted(folder) + " </dev/null"));
        for (const fs::path& part : filesBelow(folder))
            if (isReadable(part) && fs::file_size(part) > 0)  // an empty one stands for no shape
                corpus_.files.push_back(
                    {corpus_.name, name + "/" + part.lexically_relative(folder).string(), part});
    }

    Corpus corpus_;
    fs::path scratch_;
    int unpacked_ = 0;
};

}  // namespace

std::vector<Corpus> corpora(const fs::path& scratch)
{
    std::vector<Corpus> all;
    if (const auto models = testing::modelsFolder())
        all.push_back(Collector("models", *models, scratch).corpus());
    for (const Place& place : kPackages)
        all.push_back(Collector(place.name, place.folder, scratch).corpus());
    return all;
}

std::vector<ModelFile> shuffled(std::vector<ModelFile> files)
{
    std::mt19937 random(8);  // std::shuffle() is not the same everywhere
    for (size_t k = files.size(); k > 1; --k)
        std::swap(files[k - 1], files[random() % k]);
    return files;
}

std::vector<ModelFile> shareOf(const std::vector<ModelFile>& files, size_t n, size_t m)
{
    std::vector<ModelFile> share;
    for (size_t k = n - 1; k < files.size(); k += m)
        share.push_back(files[k]);
    return share;
}

}  // namespace knotspan::corpus
