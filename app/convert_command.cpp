#include <memory>
#include <set>

#include <unistd.h>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/mesh_output.h"
#include "app/output.h"

namespace knotspan::app {
namespace {

namespace fs = std::filesystem;

struct Options {
    std::vector<std::string> files;
    std::string to;
    std::string folder;
    double deviation = 0;
    double angle = 0;
    bool verify = false;
};

struct Job {
    fs::path input;
    fs::path output;
};

MeshOptions meshOptions(const Options& options)
{
    MeshOptions mesh{options.deviation, {}};
    if (options.angle > 0)
        mesh.angleDegrees = options.angle;
    return mesh;
}

void checkTarget(const std::string& option, const fs::path& path, const Options& options)
{
    if (!meshKindOf(path, meshOptions(options)))
        checkWritable(option, path);
    else if (options.verify)
        throw CLI::ValidationError("--verify", "compares surfaces; a mesh's deviation is always measured");
}

std::vector<Job> jobsOf(const Options& options)
{
    if (options.to.empty() != options.folder.empty())
        throw CLI::RequiredError(options.to.empty() ? "--to EXT" : "-d DIR");
    if (options.to.empty()) {
        if (options.files.size() != 2)
            throw CLI::ValidationError("convert", "needs one file to read and one to write, or --to and -d");
        checkTarget("OUT", options.files[1], options);
        return {{options.files[0], options.files[1]}};
    }
    const std::string extension = options.to.front() == '.' ? options.to : "." + options.to;
    std::vector<Job> jobs;
    std::set<fs::path> outputs;
    for (const std::string& file : options.files) {
        const fs::path output = fs::path(options.folder) / (fs::path(file).stem().string() + extension);
        if (!outputs.insert(output).second)
            throw CLI::ValidationError("convert", "two of the files would both become " + output.string());
        jobs.push_back({file, output});
    }
    checkTarget("--to", "model" + extension, options);
    return jobs;
}

// Writes beside `output`, reads that back, and only then gives it its name.
Result<void> writeVerified(const Scene& scene, const fs::path& output)
{
    const fs::path trial = output.parent_path() / ("." + output.stem().string() + "-" +
                                                   std::to_string(::getpid()) + output.extension().string());
    auto result = formats::write(scene, trial);
    std::error_code error;
    if (!result)
        return tl::unexpected<Error>({result.error().what, output.string(), result.error().remedy});
    const auto back = formats::read(trial);
    if (back && *back == scene && back->units() == scene.units()) {
        fs::rename(trial, output, error);
        if (!error)
            return {};
        result = failure("The file cannot be written (" + error.message() + ")", "Choose another place");
    } else {
        result = failure(back ? "What was written does not read back equal" : back.error().what,
                         "Please report this with the model");
    }
    fs::remove(trial, error);
    return tl::unexpected(result.error().at(output.string()));
}

Result<void> convert(const Job& job, const Options& options)
{
    const auto scene = readModel(job.input);
    if (!scene)
        return tl::unexpected(scene.error());
    if (const auto kind = meshKindOf(job.output, meshOptions(options)))
        return writeMeshOf(*scene, job.output, *kind, meshOptions(options));
    return options.verify ? writeVerified(*scene, job.output) : formats::write(*scene, job.output);
}

int run(const Options& options)
{
    const std::vector<Job> jobs = jobsOf(options);
    if (!options.folder.empty()) {
        std::error_code error;
        if (!fs::is_directory(options.folder, error))
            return failed(Error{"There is no such folder", options.folder, "Make it, or choose another"});
    }
    int exitCode = kDone;
    for (const Job& job : jobs)
        if (const auto done = convert(job, options); !done)
            exitCode = failed(done.error());
    return exitCode;
}

}  // namespace

void addConvertCommand(CLI::App& app, int& exitCode)
{
    const auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("convert", "Turn models into another format");
    command->add_option("FILES", options->files, "IN OUT, or with --to any number of files to read")
        ->required()
        ->type_name("");
    command->add_option("--to", options->to, "Extension of the files to write")->type_name("EXT");
    command->add_option("-d,--directory", options->folder, "Folder for the files to write")->type_name("DIR");
    command
        ->add_option("--deviation", options->deviation,
                     "How far a mesh may lie from the surface, in model units; NURBS formats are exact")
        ->check(within(1e-12, 1e12))
        ->type_name("D");
    command
        ->add_option("--angle", options->angle,
                     "How far a mesh's normals may turn from the surface's; NURBS formats are exact")
        ->check(within(0.01, 180))
        ->type_name("DEG");
    command->add_flag("--verify", options->verify,
                      "Read the output back and compare before it gets its name");
    command->callback([options, &exitCode] { exitCode = run(*options); });
}

}  // namespace knotspan::app
