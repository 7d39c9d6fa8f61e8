#include <iostream>
#include <memory>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/output.h"
#include "model/samples/sample_list.h"

namespace knotspan::app {
namespace {

struct Options {
    std::string name;
    std::string output;
};

void list()
{
    for (const Sample& sample : samples())
        std::cout << sample.name << '\t' << sample.description << '\n';
}

int run(const Options& options)
{
    if (options.name.empty()) {
        if (!options.output.empty())
            throw CLI::RequiredError("NAME");
        list();
        return kDone;
    }
    const Sample* sample = findSample(options.name);
    if (sample == nullptr) {
        std::vector<std::string> names;
        for (const Sample& known : samples())
            names.push_back(known.name);
        refuseName("NAME", options.name, names);
    }
    if (options.output.empty())
        throw CLI::RequiredError("-o FILE");
    checkWritable("--output", options.output);
    const auto written = formats::write(sample->make(), options.output);
    return written ? kDone : failed(written.error());
}

}  // namespace

void addSampleCommand(CLI::App& app, int& exitCode)
{
    const auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("sample", "List the sample models, or write one");
    command->add_option("NAME", options->name, "Which sample; without it they are listed");
    command->add_option("-o,--output", options->output, "File to write")->type_name("FILE");
    command->callback([options, &exitCode] { exitCode = run(*options); });
}

}  // namespace knotspan::app
