#include <memory>

#include "app/commands.h"
#include "ui/window_app.h"

namespace knotspan::app {
namespace {

// A mistyped command would otherwise be a file that does not exist.
void refuseMistypedCommand(const std::vector<std::string>& files)
{
    for (const std::string& file : files)
        if (std::error_code error;
            file.find_first_of("./") == std::string::npos && !std::filesystem::exists(file, error))
            throw CLI::ValidationError("'" + file + "'", "is neither a command nor a file");
}

}  // namespace

void addWindowCommand(CLI::App& app, int& exitCode, int& argc, char** argv)
{
    const auto files = std::make_shared<std::vector<std::string>>();
    const auto open = [files, &exitCode, &argc, argv] {
        exitCode = runWindow(argc, argv, {files->begin(), files->end()});
    };
    app.add_option("FILE", *files, "Model to open in the window");
    CLI::App* window = app.add_subcommand("window", "Open the window (what happens without a command, too)");
    window->add_option("FILE", *files, "Model to open");
    window->callback(open);
    app.final_callback([&app, files, open] {
        if (!app.get_subcommands().empty()) {
            if (!app.get_option("FILE")->empty())
                throw CLI::ExtrasError("knotspan", {files->begin(), files->end()});
            return;
        }
        refuseMistypedCommand(*files);
        open();
    });
}

}  // namespace knotspan::app
