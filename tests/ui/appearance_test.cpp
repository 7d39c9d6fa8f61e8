// Light and dark windows, chosen while they are open.
#include "ui/appearance.h"

#include <cmath>

#include <gtest/gtest.h>

#include <QAction>
#include <QSettings>
#include <QTimer>

#include "tests/ui/window_harness.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

// https://www.w3.org/TR/WCAG21/#dfn-relative-luminance
double luminance(const QColor& colour)
{
    const auto linear = [](double part) {
        return part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

double contrast(const QColor& a, const QColor& b)
{
    const double p = luminance(a);
    const double q = luminance(b);
    return (std::max(p, q) + 0.05) / (std::min(p, q) + 0.05);
}

class AppearanceTest : public ::testing::Test {
protected:
    void TearDown() override
    {
        setAppearance(Appearance::system);
        QSettings().clear();
    }
    void choose(const char* id)
    {
        window.action(id)->trigger();
        QCoreApplication::processEvents();  // windows hear of it by an event
    }
    [[nodiscard]] bool isDark() const
    {
        const QPalette palette = window.palette();
        return luminance(palette.color(QPalette::Window)) < luminance(palette.color(QPalette::WindowText));
    }

    Answers answers;
    MainWindow window{answering(answers)};
};

// Windows hear of colours only while the program runs.
template <class Steps>
void whileRunning(const Steps& steps)
{
    QTimer::singleShot(0, [&] {
        steps();
        QCoreApplication::quit();
    });
    QApplication::exec();
}

TEST_F(AppearanceTest, AnOpenWindowFollowsAtOnce)
{
    window.show();
    const QPalette system = window.palette();
    whileRunning([&] {
        choose("view.appearanceDark");
        EXPECT_TRUE(isDark());
        EXPECT_TRUE(window.action("view.appearanceDark")->isChecked());
        EXPECT_FALSE(window.action("view.appearanceSystem")->isChecked());
        choose("view.appearanceLight");
        EXPECT_FALSE(isDark());
        choose("view.appearanceSystem");
        EXPECT_EQ(window.palette(), system);
        EXPECT_TRUE(window.action("view.appearanceSystem")->isChecked());
    });
}

TEST_F(AppearanceTest, TheNextStartHasIt)
{
    setAppearance(Appearance::dark);
    const QVariant kept = QSettings().value("appearance");
    setAppearance(Appearance::system);
    QSettings().setValue("appearance", kept);
    restoreAppearance();
    EXPECT_EQ(appearance(), Appearance::dark);
    EXPECT_EQ(QApplication::palette().color(QPalette::Window), darkPalette().color(QPalette::Window));
}

// https://www.w3.org/TR/WCAG21/#contrast-minimum
TEST_F(AppearanceTest, TextIsReadableInBoth)
{
    using Pair = std::pair<QPalette::ColorRole, QPalette::ColorRole>;
    for (const QPalette& palette : {lightPalette(), darkPalette()}) {
        for (const auto& [ground, ink] :
             {Pair{QPalette::Window, QPalette::WindowText}, Pair{QPalette::Base, QPalette::Text},
              Pair{QPalette::AlternateBase, QPalette::Text}, Pair{QPalette::Button, QPalette::ButtonText},
              Pair{QPalette::ToolTipBase, QPalette::ToolTipText},
              Pair{QPalette::Highlight, QPalette::HighlightedText}, Pair{QPalette::Base, QPalette::Link},
              Pair{QPalette::Window, QPalette::Link}, Pair{QPalette::Base, QPalette::LinkVisited}})
            EXPECT_GE(contrast(palette.color(ground), palette.color(ink)), 4.5) << ground << " " << ink;
        // What is not possible is faint, not gone.
        EXPECT_GE(contrast(palette.color(QPalette::Window),
                           palette.color(QPalette::Disabled, QPalette::WindowText)),
                  2.5);
        EXPECT_LT(contrast(palette.color(QPalette::Window),
                           palette.color(QPalette::Disabled, QPalette::WindowText)),
                  4.5);
    }
}

}  // namespace
}  // namespace knotspan
