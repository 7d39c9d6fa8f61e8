// Hostile files of every format that can be read, opened as the window opens them: a sentence or a model
// each, this process alive, the open document untouched, memory bounded, no process left behind. Formats that
// are read by a process of their own take a start of the program each: KNOTSPAN_SOAK=1 changes a thousand
// single bytes of them, too.
#include <algorithm>
#include <atomic>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <thread>

#include <gtest/gtest.h>

#include "model/document/document.h"
#include "model/formats/format_list.h"
#include "model/formats/isolated_import.h"
#include "model/samples/sample_list.h"
#include "tests/model/formats/hostile_files.h"
#include "tests/model/formats/import_scripts.h"
#include "tests/model/formats/real_importer.h"
#include "tests/support.h"

namespace knotspan::testing {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kKeepsFreedMemory = true;
#else
constexpr bool kKeepsFreedMemory = false;
#endif

// A document at work: what a file that cannot be read must leave as it is.
class OpenDocument {
public:
    OpenDocument() { startAgain(); }

    [[nodiscard]] Result<void> open(const std::filesystem::path& path) { return document_.open(path); }

    [[nodiscard]] bool isUntouched() const
    {
        return document_.scene() == scene_ && document_.history().count() == 1 && document_.isModified() &&
               document_.title() == "At work" && document_.file().empty();
    }
    [[nodiscard]] bool isEmpty() const
    {
        return document_.scene().objects().empty() && document_.scene().meshes().empty();
    }

    void startAgain()
    {
        document_.reset(findSample("nine-16")->make(), "At work");
        SceneObject object = *document_.scene().objects().begin()->second;
        object.name = "changed";
        Edit edit;
        edit.set(document_.scene().objects().begin()->first,
                 std::make_shared<const SceneObject>(std::move(object)));
        document_.apply(edit, "Rename");
        scene_ = document_.scene();
    }

private:
    Document document_;
    Scene scene_;
};

struct Outcomes {
    std::atomic<int> read = 0;
    std::atomic<int> refused = 0;
    std::atomic<int> crashed = 0;  // the process that read it
};

enum class Expected { whatever, refusal };

class HostileFormats : public ::testing::TestWithParam<std::string> {
protected:
    ~HostileFormats() override { EXPECT_EQ(childProcessesLeft(), 0); }

    [[nodiscard]] static const formats::Format& format() { return *formats::find("file." + GetParam()); }
    [[nodiscard]] static bool isReadApart() { return format().readIsolated != nullptr; }
    [[nodiscard]] static int changes()
    {
        return !isReadApart() || std::getenv("KNOTSPAN_SOAK") != nullptr ? 1000 : 24;
    }

    void openAll(const std::vector<HostileFile>& files, Expected expected)
    {
        std::atomic<size_t> next = 0;
        const auto work = [&](size_t worker) {
            OpenDocument document;
            for (size_t k = next++; k < files.size(); k = next++)
                open(document, files[k], folder_ / (std::to_string(worker) + "." + files[k].extension),
                     expected);
        };
        std::vector<std::thread> workers;
        for (size_t k = 0; k < std::clamp(std::thread::hardware_concurrency(), 1U, 8U); ++k)
            workers.emplace_back(work, k);
        for (std::thread& worker : workers)
            worker.join();
        RecordProperty("crashed", outcomes_.crashed);
    }

    [[nodiscard]] std::vector<HostileFile> wholeFiles() const
    {
        return wholeFilesOf(format(), folder_.path());
    }

    Outcomes outcomes_;
    std::string lastSentence_;

private:
    void open(OpenDocument& document, const HostileFile& file, const std::filesystem::path& path,
              Expected expected)
    {
        writeFile(path, file.content);
        const auto opened = document.open(path);
        if (opened) {
            ++outcomes_.read;
            EXPECT_EQ(expected, Expected::whatever) << file.name << ": was read";
            EXPECT_FALSE(document.isEmpty()) << file.name;
            document.startAgain();
            return;
        }
        ++outcomes_.refused;
        const std::string sentence = opened.error().sentence();
        {
            const std::scoped_lock lock(mutex_);
            lastSentence_ = sentence;
        }
        EXPECT_EQ(sentence.rfind(path.string(), 0), 0U) << file.name << ": " << sentence;
        EXPECT_GT(sentence.size(), path.string().size() + 10) << file.name;
        EXPECT_EQ(sentence.back(), '.') << sentence;
        EXPECT_EQ(std::count_if(sentence.begin(), sentence.end(),
                                [](unsigned char c) { return std::iscntrl(c) != 0; }),
                  0)
            << file.name << ": " << sentence;
        // The importer talks sense, neither hangs nor takes the machine's memory for a small file.
        for (const char* never :
             {"an answer that is no model", "takes longer", "cannot be started", "the memory"})
            EXPECT_EQ(sentence.find(never), std::string::npos) << file.name << ": " << sentence;
        EXPECT_TRUE(document.isUntouched()) << file.name;
        outcomes_.crashed += sentence.find("crashed") != std::string::npos ? 1 : 0;
    }

    std::mutex mutex_;
    const RealImporter importer_;
    TemporaryFolder folder_;
};

TEST_P(HostileFormats, StartFromFilesThatAreModels)
{
    const auto files = wholeFiles();
    ASSERT_FALSE(files.empty()) << "hostile_files.cpp needs a small file of the format " << format().name;
    openAll(files, Expected::whatever);
    EXPECT_EQ(outcomes_.refused, 0) << lastSentence_;
}

TEST_P(HostileFormats, CutOffAtEvery64thAreReadOrRefused)
{
    for (const HostileFile& whole : wholeFiles())
        openAll(cutOff(whole, 64), Expected::whatever);
    EXPECT_GT(outcomes_.refused, 0);
}

TEST_P(HostileFormats, WithSingleBytesChangedAreReadOrRefused)
{
    for (const HostileFile& whole : wholeFiles())
        openAll(withOneByteChanged(whole, changes()), Expected::whatever);
    EXPECT_GT(outcomes_.refused + outcomes_.read, 0);
}

TEST_P(HostileFormats, EmptyOrOfRandomBytesAreRefused)
{
    for (const std::string& extension : format().extensions) {
        openAll({{"empty", extension, {}},
                 {"a byte", extension, "x"},
                 {"zeros", extension, std::string(999, '\0')}},
                Expected::refusal);
        openAll(ofRandomBytes(extension, isReadApart() ? 4 : 100), Expected::refusal);
    }
}

TEST_P(HostileFormats, WithReferencesInACircleAreReadOrRefused)
{
    for (const HostileFile& whole : wholeFiles())
        openAll(cyclicFilesOf(whole), Expected::whatever);
}

std::uint64_t largestResident()
{
    std::ifstream status("/proc/self/status");
    std::uint64_t kilobytes = 0;
    for (std::string word; status >> word;)
        if (word == "VmHWM:" && status >> kilobytes)
            break;
    return kilobytes << 10;
}

TEST_P(HostileFormats, ThatClaimTheImpossibleAreRefusedInLittleMemory)
{
    std::ofstream("/proc/self/clear_refs") << '5';  // the largest from now on
    const std::uint64_t before = largestResident();
    for (const std::string& extension : format().extensions)
        openAll(impossibleFilesOf(extension), Expected::refusal);
    if (!kKeepsFreedMemory) {
        EXPECT_LT(largestResident() - before, std::uint64_t{1} << 30);
    }
}

// By the first extension of each.
std::vector<std::string> readable()
{
    std::vector<std::string> list;
    for (const formats::Format& format : formats::all())
        if (format.read != nullptr)
            list.push_back(format.extensions.front());
    return list;
}

INSTANTIATE_TEST_SUITE_P(Every, HostileFormats, ::testing::ValuesIn(readable()),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace knotspan::testing
