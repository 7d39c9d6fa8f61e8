#include <iostream>
#include <memory>
#include <set>
#include <sstream>

#include "app/arguments.h"
#include "app/child_processes.h"
#include "app/commands.h"
#include "app/conversion.h"
#include "app/output.h"
#include "app/standard_streams.h"

namespace knotspan::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStream = "-";

struct Options {
    std::vector<std::string> files;
    std::string from;
    std::string to;
    std::string folder;
    double angle = 0;
    int jobs = 1;
    bool json = false;
    ConvertOptions each;
};

std::string withoutDot(const std::string& extension)
{
    return extension.substr(extension.rfind('.', 0) == 0 ? 1 : 0);
}

std::string alsoMeshes()
{
    std::string text = "; as a mesh";
    for (const formats::MeshFormat& format : formats::meshFormats())
        text += (text.back() == 'h' ? " " : ", ") + format.extension;
    return text;
}

void checkTarget(const std::string& option, const fs::path& path, const Options& options)
{
    if (!meshKindOf(path, options.each))
        checkWritable(option, path, alsoMeshes());
}

void checkPair(const Options& options)
{
    if (options.files.size() != 2)
        throw CLI::ValidationError("convert", "needs one file to read and one to write, or --to and -d");
    const bool fromStream = options.files[0] == kStream;
    const bool toStream = options.files[1] == kStream;
    if (fromStream == options.from.empty())
        throw CLI::ValidationError("--from", fromStream ? "is needed to read standard input"
                                                        : "is only for standard input, named -");
    if (toStream == options.to.empty())
        throw CLI::ValidationError("--to", toStream ? "is needed to write standard output"
                                                    : "needs -d, or - as the file to write");
    if (toStream && options.json)
        throw CLI::ValidationError("--json", "cannot go where the model goes");
    if (fromStream) {
        const formats::Format* format = formats::find("model." + withoutDot(options.from));
        if (format == nullptr || format->read == nullptr)
            throw CLI::ValidationError("--from", "'" + options.from + "' is no format that can be read");
    }
    if (toStream)
        checkTarget("--to", "model." + withoutDot(options.to), options);
    else
        checkTarget("OUT", options.files[1], options);
}

std::vector<Conversion> manyOf(const Options& options)
{
    if (options.to.empty())
        throw CLI::RequiredError("--to EXT");
    const std::string extension = "." + withoutDot(options.to);
    std::vector<Conversion> conversions;
    std::set<fs::path> outputs;
    for (const std::string& file : options.files) {
        if (file == kStream || !options.from.empty())
            throw CLI::ValidationError("convert", "reads standard input alone, without -d");
        const fs::path output = fs::path(options.folder) / (fs::path(file).stem().string() + extension);
        if (!outputs.insert(output).second)
            throw CLI::ValidationError("convert", "two of the files would both become " + output.string());
        conversions.push_back({file, output, {}, {}});
    }
    checkTarget("--to", "model" + extension, options);
    return conversions;
}

int runPair(const Options& options)
{
    const StreamFolder folder;
    Conversion conversion{options.files[0], options.files[1], {}, {}};
    const bool toStream = options.files[1] == kStream;
    if (options.files[0] == kStream) {
        const auto input = folder.input(withoutDot(options.from));
        if (!input)
            return failed(input.error());
        conversion.input = *input;
        conversion.inputName = kStream;
    }
    if (toStream) {
        const auto place = folder.place(withoutDot(options.to));
        if (!place)
            return failed(place.error());
        conversion.output = *place;
        conversion.outputName = kStream;
    }
    ConversionReport report = convert(conversion, options.each);
    if (toStream && !report.error)
        if (const auto sent = sendToOutput(conversion.output); !sent)
            report.error = sent.error();
    if (options.json)
        std::cout << jsonOf(report) << '\n';
    else if (const std::string sentence = sentenceOf(report); !report.error && !sentence.empty())
        (toStream ? std::cerr : std::cout) << sentence << '\n';
    if (report.error)
        return failed(*report.error);
    return report.missesDeviation() ? kToleranceMissed : kDone;
}

// As a process of its own is to convert it.
std::vector<std::string> callOf(const Conversion& conversion, const Options& options)
{
    // A file's name may begin as an option does.
    const auto plain = [](const fs::path& path) {
        return path.string().rfind('-', 0) == 0 ? "./" + path.string() : path.string();
    };
    const auto exact = [](double number) {
        std::ostringstream text;
        text.precision(17);
        text << number;
        return text.str();
    };
    std::vector<std::string> call{"convert", plain(conversion.input), plain(conversion.output)};
    if (options.each.deviation > 0)
        call.insert(call.end(), {"--deviation", exact(options.each.deviation)});
    if (options.each.angleDegrees)
        call.insert(call.end(), {"--angle", exact(*options.each.angleDegrees)});
    if (options.each.verify)
        call.emplace_back("--verify");
    if (options.json)
        call.emplace_back("--json");
    return call;
}

int runMany(const std::vector<Conversion>& conversions, const Options& options)
{
    std::error_code error;
    if (!fs::is_directory(options.folder, error))
        return failed(Error{"There is no such folder", options.folder, "Make it, or choose another"});
    std::vector<std::vector<std::string>> calls;
    for (const Conversion& conversion : conversions)
        calls.push_back(callOf(conversion, options));
    int exitCode = kDone;
    runChildren(calls, options.jobs, [&](size_t k, const ChildRun& run) {
        std::cerr << run.messages << std::flush;
        std::cout << run.output;
        if (!run.isDone() && exitCode != kFailed)
            exitCode = run.exitCode() == kToleranceMissed ? kToleranceMissed : kFailed;
        if (run.hasCrashed() || (options.json && run.output.empty())) {
            ConversionReport report;
            report.input = conversions[k].input.string();
            report.output = conversions[k].output.string();
            report.error = Error{"The conversion ended before it was done (" + run.end() + ")", report.input,
                                 "Convert this file alone, or report it"};
            report.seconds = run.seconds;
            report.peakMebibytes = run.peakMebibytes;
            if (options.json)
                std::cout << jsonOf(report) << '\n';
            (void)failed(*report.error);
        }
        std::cout.flush();
    });
    return exitCode;
}

int run(Options& options)
{
    if (options.angle > 0)
        options.each.angleDegrees = options.angle;
    if (!options.folder.empty())
        return runMany(manyOf(options), options);
    checkPair(options);
    return runPair(options);
}

}  // namespace

void addConvertCommand(CLI::App& app, int& exitCode)
{
    const auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "convert", "Turn models into another format; exit code 3 where a mesh misses its deviation");
    command
        ->add_option("FILES", options->files,
                     "IN OUT, each may be - with --from or --to; or with --to and -d any number to read")
        ->required()
        ->type_name("");
    command->add_option("--from", options->from, "Extension that tells what standard input is")
        ->type_name("EXT");
    command->add_option("--to", options->to, "Extension of the files to write")->type_name("EXT");
    command->add_option("-d,--directory", options->folder, "Folder for the files to write")->type_name("DIR");
    command
        ->add_option("--deviation", options->each.deviation,
                     "How far a mesh may lie from the surface, in model units; NURBS formats are exact")
        ->check(within(1e-12, 1e12))
        ->type_name("D");
    command
        ->add_option("--angle", options->angle,
                     "How far a mesh's normals may turn from the surface's; NURBS formats are exact")
        ->check(within(0.01, 180))
        ->type_name("DEG");
    command->add_flag("--verify", options->each.verify,
                      "Read the output back, compare, and say how far it is off, before it gets its name");
    command->add_option("--jobs", options->jobs, "How many files to convert at a time")
        ->check(wholeWithin(1, 1024))
        ->type_name("N");
    command->add_flag("--json", options->json, "A line of JSON for each file");
    command->callback([options, &exitCode] { exitCode = run(*options); });
}

}  // namespace knotspan::app
