// The pictures of the user guide: each can be made, and shows what no other shows.
#include <fstream>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include <QApplication>

#include "tests/support.h"
#include "tests/tour/tour.h"

namespace knotspan::testing {
namespace {

const std::filesystem::path kGuide = std::filesystem::path(KNOTSPAN_SOURCE_DIR) / "docs" / "user-guide.md";

// Closes what a station opened beside the window.
void closeOthers(MainWindow& window)
{
    for (QWidget* top : QApplication::topLevelWidgets())
        if (top != &window && top->isWindow() && top->isVisible())
            top->close();
    settle(window);
}

// How many colours the picture has, coarsely: of a window that shows a model more than of an empty one.
size_t coloursOf(const QImage& image)
{
    std::set<QRgb> colours;
    for (int y = 0; y < image.height(); y += 3)
        for (int x = 0; x < image.width(); x += 3)
            colours.insert(image.pixel(x, y) & 0xf0f0f0);
    return colours.size();
}

TEST(Tour, MakesEveryPictureOfTheGuideWithoutAWordOfTrouble)
{
    const TemporaryFolder folder;
    const QByteArray wanted = qgetenv("KNOTSPAN_TOUR_PICTURES");
    const std::filesystem::path target =
        wanted.isEmpty() ? folder.path() : std::filesystem::path(wanted.toStdString());
    Tour tour;
    if (tour.viewport().renderer() == nullptr)
        GTEST_SKIP() << "no Vulkan device here";
    std::vector<QImage> seen;
    for (const TourStation& station : tourStations()) {
        SCOPED_TRACE(station.name);
        station.go(tour);
        const QImage picture = tour.screenshot();
        EXPECT_GT(coloursOf(picture), 30U);
        EXPECT_EQ(tour.window().message().toStdString(), "");
        for (const QImage& other : seen)
            EXPECT_GT(differingPixels(picture, other), 500);
        seen.push_back(picture);
        EXPECT_TRUE(
            picture.save(QString::fromStdString((target / (std::string(station.name) + ".png")).string())));
        closeOthers(tour.window());
    }
    EXPECT_TRUE(tour.viewport().renderer()->validationMessages().empty());
}

TEST(Tour, IsTheGuidesPicturesAndNoOthers)
{
    std::ifstream file(kGuide);
    ASSERT_TRUE(file);
    const std::string guide{std::istreambuf_iterator<char>(file), {}};
    std::vector<std::string> shown;
    const std::regex picture(R"(\]\(pictures/guide/([a-z]+)\.png\))");
    for (std::sregex_iterator at(guide.begin(), guide.end(), picture), end; at != end; ++at)
        shown.push_back((*at)[1]);
    std::vector<std::string> made;
    for (const TourStation& station : tourStations())
        made.emplace_back(station.name);
    EXPECT_EQ(shown, made);
    for (const std::string& name : made)
        EXPECT_TRUE(std::filesystem::exists(kGuide.parent_path() / "pictures" / "guide" / (name + ".png")))
            << name;
}

}  // namespace
}  // namespace knotspan::testing
