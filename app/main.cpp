// The program: one executable, the window and the commands that need no display.
#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>

#include "app/commands.h"
#include "app/output.h"
#include "model/files/unfinished_files.h"
#include "model/formats/isolated_import.h"

namespace {

using namespace knotspan::app;
namespace formats = knotspan::formats;

// What CLI11 says, as one sentence.
std::string sentenceOf(const CLI::ParseError& error)
{
    std::string text = error.what();
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (!text.empty() && (text.back() == '.' || text.back() == ' '))
        text.pop_back();
    return text + ". 'knotspan --help' and 'knotspan COMMAND --help' list what there is.";
}

int run(int& argc, char** argv)
{
    CLI::App app("Knotspan: shape free-form surfaces and see the exact NURBS.", "knotspan");
    app.set_version_flag("--version", "knotspan " KNOTSPAN_VERSION);
    app.require_subcommand(0, 1);
    formats::setImportWorker("/proc/self/exe");
    int exitCode = kDone;
    addWindowCommand(app, exitCode, argc, argv);
    addRenderCommand(app, exitCode);
    addConvertCommand(app, exitCode);
    addInfoCommand(app, exitCode);
    addAnalyzeCommand(app, exitCode);
    addCompareCommand(app, exitCode);
    addSampleCommand(app, exitCode);
    addEvaluateCommand(app, exitCode);
    addMeasureCommand(app, exitCode);
    addImportWorkerCommand(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // --help, --version
        app.exit(asked);
    } catch (const CLI::ParseError& error) {
        tell(sentenceOf(error));
        return kWrongCall;
    }
    return exitCode;
}

// What is half written goes; then the signal does what it always does.
void endTidily(int number)
{
    formats::removeUnfinishedFiles();
    std::signal(number, SIG_DFL);
    std::raise(number);
}

}  // namespace

int main(int argc, char** argv)
{
    // A file that may not grow is a failure like any other, not the end.
    std::signal(SIGXFSZ, SIG_IGN);
    for (const int number : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(number, endTidily) == SIG_IGN)  // as nohup wants it
            std::signal(number, SIG_IGN);
    int exitCode = kFailed;
    try {
        exitCode = run(argc, argv);
    } catch (const std::bad_alloc&) {
        tell("There is not enough memory for this. Try a smaller model or picture.");
    } catch (const std::exception& error) {
        tell(std::string("This failed: ") + error.what() + '.');
    }
    if (!std::cout.flush()) {
        tell("Standard output cannot be written. Check the place it goes to.");
        return kFailed;
    }
    return exitCode;
}
