// What tests of every layer share: where the real models lie, and folders for what they write.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace knotspan::testing {

// Seconds. What is to take a moment and takes longer hangs: busy machines make things ten times slower, not a
// thousand times.
inline constexpr int kHang = 60;

// The folder with the real models: KNOTSPAN_MODELS, or `models` in the folder `shared` beside the checkout.
// Nothing where it is absent: tests then skip with a message, by KNOTSPAN_NEED_MODELS(folder).
[[nodiscard]] std::optional<std::filesystem::path> modelsFolder();
// Its neighbour with values from other programs.
[[nodiscard]] std::optional<std::filesystem::path> oraclesFolder();

// A folder that is empty when the object is made and gone with it.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

[[nodiscard]] std::string readFile(const std::filesystem::path& path);
void writeFile(const std::filesystem::path& path, const std::string& content);

}  // namespace knotspan::testing

#define KNOTSPAN_NEED_MODELS(folder)                         \
    const auto folder = ::knotspan::testing::modelsFolder(); \
    if (!folder)                                             \
    GTEST_SKIP() << "no real models here: set KNOTSPAN_MODELS to a folder of STEP files to run this test"
