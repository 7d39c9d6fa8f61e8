#include "app/output.h"

#include <iostream>
#include <memory>

#include <unistd.h>

#include <QSaveFile>

#include "app/commands.h"

namespace knotspan::app {
namespace {

tl::unexpected<Error> unwritable(const std::filesystem::path& path, const QSaveFile& file)
{
    return tl::unexpected<Error>(
        Error{"The file cannot be written (" + file.errorString().toStdString() + ")", path.string(),
              "Choose another place"});
}

// How far a long reading is, on a line that is written over and wiped at the end; only where a person looks.
class ProgressLine {
public:
    ~ProgressLine()
    {
        if (isShown_)
            std::cerr << kWiped;
    }
    void operator()(const std::filesystem::path& path, const std::string& stage)
    {
        static const bool isSeen = ::isatty(STDERR_FILENO) == 1;
        if (!isSeen)
            return;
        isShown_ = true;
        std::cerr << kWiped << path.filename().string() << ": " << stage << std::flush;
    }

private:
    static constexpr const char* kWiped = "\r\033[K";
    bool isShown_ = false;
};

}  // namespace

Result<void> writeFiles(const std::vector<OutputFile>& files)
{
    std::vector<std::unique_ptr<QSaveFile>> saved;
    for (const OutputFile& file : files) {
        saved.push_back(std::make_unique<QSaveFile>(QString::fromStdString(file.path.string())));
        if (!saved.back()->open(QIODevice::WriteOnly) || !file.write(*saved.back()) || !saved.back()->flush())
            return unwritable(file.path, *saved.back());
    }
    for (size_t k = 0; k < files.size(); ++k)
        if (!saved[k]->commit())
            return unwritable(files[k].path, *saved[k]);
    return {};
}

Result<void> checkPlace(const std::filesystem::path& path)
{
    QSaveFile file(QString::fromStdString(path.string()));
    if (!file.open(QIODevice::WriteOnly))
        return unwritable(path, file);
    return {};
}

void tell(const std::string& sentence)
{
    std::cerr << "knotspan: " << sentence << '\n';
}

int failed(const Error& error)
{
    tell(error.sentence());
    return kFailed;
}

Result<formats::Import> readImport(const std::filesystem::path& path, std::string name)
{
    if (name.empty())
        name = path.string();
    auto import = [&path] {
        ProgressLine line;
        const auto show = [&](const std::string& stage, double) { line(path, stage); };
        return formats::readWithNotes(path, {show, nullptr});
    }();
    if (import)
        for (const std::string& note : import->notes)
            tell(name + ": " + note);
    return import;
}

Result<Scene> readModel(const std::filesystem::path& path)
{
    return readImport(path).map([](formats::Import&& import) { return std::move(import.scene); });
}

}  // namespace knotspan::app
