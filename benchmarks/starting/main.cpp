// How long the window takes from the start of the program to the first picture of a model, and what it does
// while nobody touches it.
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>

#include <unistd.h>

#include <QApplication>
#include <QTemporaryDir>
#include <QTimer>

#include "model/formats/format_list.h"
#include "model/samples/sample_list.h"
#include "ui/document_files.h"
#include "ui/main_window.h"

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double processorMs()
{
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

int fail(const std::string& sentence)
{
    std::fprintf(stderr, "benchmark_starting: %s\n", sentence.c_str());
    return EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv)
{
    const Clock::time_point start = Clock::now();
    double idleSeconds = 5;
    std::string model;
    for (int k = 1; k < argc; ++k) {
        if (std::string_view(argv[k]) == "--idle" && k + 1 < argc)
            idleSeconds = std::atof(argv[++k]);
        else
            model = argv[k];
    }
    if (model.empty())
        return fail("usage: benchmark_starting [--idle SECONDS] SAMPLE");
    const auto* sample = knotspan::findSample(model);
    if (sample == nullptr)
        return fail("there is no sample " + model);
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath("model.knotspan").toStdString();
    if (const auto written = knotspan::formats::write(sample->make(), file); !written)
        return fail(written.error().sentence());
    const double preparingMs = millisecondsSince(start);

    const Clock::time_point began = Clock::now();
    QApplication application(argc, argv);
    knotspan::MainWindow window;
    double firstFrameMs = 0;
    int frames = 0;
    QObject::connect(&window.viewport(), &knotspan::Viewport::frameDrawn, &application,
                     [&](const knotspan::FrameStats& stats) {
                         ++frames;
                         if (firstFrameMs == 0 && stats.surfaces > 0)
                             firstFrameMs = millisecondsSince(began);
                     });
    window.files().open({file});
    window.show();
    while (firstFrameMs == 0 || window.viewport().isDrawPending())
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    // What comes after the first picture (friends, boxes) has its time, too.
    QTimer::singleShot(2000, &application, &QApplication::quit);
    QApplication::exec();

    const int framesBefore = frames;
    const double processorBefore = processorMs();
    QTimer::singleShot(static_cast<int>(1000 * idleSeconds), &application, &QApplication::quit);
    QApplication::exec();
    const double idleProcessorMs = processorMs() - processorBefore;
    const int idleFrames = frames - framesBefore;

    const Clock::time_point reading = Clock::now();
    if (const auto read = knotspan::formats::read(file); !read)
        return fail(read.error().sentence());
    std::printf("{\"model\": \"%s\", \"first_frame_ms\": %.1f, \"read_ms\": %.1f, \"idle_s\": %.1f, "
                "\"idle_frames\": %d, \"idle_cpu_ms\": %.1f, \"preparing_ms\": %.1f}\n",
                model.c_str(), firstFrameMs, millisecondsSince(reading), idleSeconds, idleFrames,
                idleProcessorMs, preparingMs);
    window.document().undoStack().setClean();
    return EXIT_SUCCESS;
}
