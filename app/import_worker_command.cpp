#include <memory>

#include "app/commands.h"
#include "model/formats/import_worker.h"

namespace knotspan::app {

void addImportWorkerCommand(CLI::App& app)
{
    const auto file = std::make_shared<std::string>();
    CLI::App* command =
        app.add_subcommand("import-worker", "Read a file for another process; the program starts it itself");
    command->group("");  // not for people
    command->add_option("FILE", *file, "Model to read")->required()->type_name("");
    command->callback([file] { formats::runImportWorker(*file); });
}

}  // namespace knotspan::app
