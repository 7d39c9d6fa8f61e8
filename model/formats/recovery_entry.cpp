#include "model/formats/recovery_entry.h"

#include <algorithm>
#include <fstream>
#include <random>
#include <utility>

#include "model/files/file_replacement.h"
#include "model/files/json_parsing.h"
#include "model/files/text_file.h"
#include "model/formats/format_list.h"
#include "model/formats/knotspan_json.h"

namespace knotspan::formats {
namespace fs = std::filesystem;

namespace {

constexpr auto kLock = "lock";
// It names the snapshot, and so decides which one counts.
constexpr auto kNote = "model.json";

constexpr std::int64_t kMostSnapshots = 1'000'000'000;

struct Noted {
    RecoveryNote note;
    int snapshot = 0;
};

fs::path snapshotName(int number)
{
    return "model-" + std::to_string(number) + ".knotspan";
}

std::vector<fs::path> entriesOf(const fs::path& folder)
{
    std::vector<fs::path> paths;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        paths.push_back(at->path());
    return paths;
}

Result<Noted> readNote(const fs::path& path)
{
    const auto text = wholeText(path, 1, "json");
    if (!text)
        return tl::unexpected(text.error());
    const auto json = parsedJson(*text);
    if (!json)
        return tl::unexpected(json.error());
    const auto has = [&](const char* name, auto isRight) {
        return json->contains(name) && (json->at(name).*isRight)();
    };
    using Json = nlohmann::json;
    if (!json->is_object() || !has("snapshot", &Json::is_number_integer) || !has("title", &Json::is_string) ||
        !has("file", &Json::is_string) || !has("imported", &Json::is_boolean) ||
        !has("seconds", &Json::is_number_integer))
        return failure("What was noted of the model cannot be understood");
    const auto snapshot = json->at("snapshot").get<std::int64_t>();
    if (snapshot < 1 || snapshot > kMostSnapshots)
        return failure("What was noted of the model names no snapshot");
    return Noted{
        {json->at("title"), json->at("file").get<std::string>(), json->at("imported"), json->at("seconds")},
        static_cast<int>(snapshot)};
}

Result<void> writeNote(const fs::path& path, const RecoveryNote& note, int snapshot)
{
    return replaceFile(path, [&](const fs::path& temporary) -> Result<void> {
        std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
        file << "{\"title\": " << textOf(note.title) << ", \"file\": " << textOf(note.file.string())
             << ", \"imported\": " << (note.isImported ? "true" : "false")
             << ", \"seconds\": " << note.seconds << ", \"snapshot\": " << snapshot << "}\n";
        file.close();
        if (!file)
            return failure("The file cannot be written", "Check that the disk has room");
        return {};
    });
}

std::string anyName()
{
    static constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz";
    std::random_device random;
    std::string name;
    for (int k = 0; k < 12; ++k)
        name += kLetters[random() % kLetters.size()];
    return name;
}

}  // namespace

RecoveryEntry::RecoveryEntry(fs::path folder, FileLock lock)
    : folder_(std::move(folder)),
      lock_(std::move(lock))
{
    if (const auto noted = readNote(folder_ / kNote))
        next_ = noted->snapshot + 1;
    std::error_code ignored;
    for (const fs::path& path : entriesOf(folder_))
        if (path.extension() == ".saving")  // who wrote it is gone
            fs::remove(path, ignored);
}

Result<std::shared_ptr<RecoveryEntry>> RecoveryEntry::create(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (!error)  // the models are nobody else's business
        fs::permissions(folder, fs::perms::owner_all, error);
    std::string reason = error ? error.message() : std::string();
    // Another process may take a folder that has no lock yet for left behind.
    for (int attempt = 0; attempt < 10 && reason.empty(); ++attempt) {
        const fs::path own = folder / anyName();
        if (!fs::create_directory(own, error)) {
            reason = error ? error.message() : std::string();
            continue;
        }
        auto lock = FileLock::make(own / kLock);
        if (!lock)
            fs::remove(own, error);
        else if (*lock && (*lock)->isHeld())
            return std::shared_ptr<RecoveryEntry>(new RecoveryEntry(own, std::move(**lock)));
        else if (*lock) {
            fs::remove_all(own, error);
            reason = "its disk knows no locks";
        }
    }
    if (reason.empty())
        reason = "it is not writable";
    return tl::unexpected<Error>({"The folder for recovery cannot be used: " + reason, folder.string(), {}});
}

std::vector<std::shared_ptr<RecoveryEntry>> RecoveryEntry::leftBehind(const fs::path& folder)
{
    std::vector<std::pair<std::int64_t, std::shared_ptr<RecoveryEntry>>> found;
    for (const fs::path& path : entriesOf(folder)) {
        auto lock = FileLock::take(path / kLock);
        if (!lock) {
            std::error_code ignored;
            if (fs::is_directory(path, ignored))
                fs::remove(path, ignored);  // where it is empty: its process came no further
            continue;
        }
        std::shared_ptr<RecoveryEntry> entry(new RecoveryEntry(path, std::move(*lock)));
        if (entry->holdsSnapshot())
            found.emplace_back(entry->note().map([](const RecoveryNote& n) { return n.seconds; }).value_or(0),
                               entry);
        else
            entry->remove();
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<std::shared_ptr<RecoveryEntry>> entries;
    for (auto& [seconds, entry] : found)
        entries.push_back(std::move(entry));
    return entries;
}

bool RecoveryEntry::holdsSnapshot() const
{
    std::error_code error;
    return fs::exists(folder_ / kNote, error);
}

Result<void> RecoveryEntry::write(const Scene& scene, const RecoveryNote& note, int epoch)
{
    if (epoch != epoch_)
        return {};
    const int number = next_++;
    const fs::path snapshot = folder_ / snapshotName(number);
    auto written = formats::write(scene, snapshot);
    if (written && epoch == epoch_)
        written = writeNote(folder_ / kNote, note, number);
    std::error_code ignored;
    if (epoch != epoch_) {  // forgotten meanwhile
        fs::remove(folder_ / kNote, ignored);
        fs::remove(snapshot, ignored);
        return {};
    }
    if (written)
        removeOthersThan(snapshot);
    else
        fs::remove(snapshot, ignored);
    return written;
}

Result<RecoveryNote> RecoveryEntry::note() const
{
    return readNote(folder_ / kNote).map([](Noted&& noted) { return std::move(noted.note); });
}

Result<Scene> RecoveryEntry::read() const
{
    const auto noted = readNote(folder_ / kNote);
    if (!noted)
        return tl::unexpected(noted.error().at((folder_ / kNote).string()));
    return formats::read(folder_ / snapshotName(noted->snapshot));
}

void RecoveryEntry::forget()
{
    ++epoch_;
    std::error_code ignored;
    fs::remove(folder_ / kNote, ignored);
    removeOthersThan({});
}

void RecoveryEntry::remove()
{
    forget();
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

// What a write() elsewhere is at has another ending.
void RecoveryEntry::removeOthersThan(const fs::path& kept) const
{
    std::error_code ignored;
    for (const fs::path& path : entriesOf(folder_))
        if (path.extension() == ".knotspan" && path != kept)
            fs::remove(path, ignored);
}

}  // namespace knotspan::formats
