#include "app/conversion.h"

#include <algorithm>
#include <chrono>

#include <sys/resource.h>

#include "app/output.h"
#include "model/formats/verified_writing.h"

namespace knotspan::app {

namespace {

// Of this process and of the importer, whichever was larger.
double peakMebibytes()
{
    double most = 0;
    for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage usage{};
        if (::getrusage(who, &usage) == 0)
            most = std::max(most, static_cast<double>(usage.ru_maxrss) / 1024);
    }
    return most;
}

void note(ConversionReport& report, const std::string& sentence)
{
    tell(report.output + ": " + sentence);
    report.notes.push_back(sentence);
}

// Formats of surfaces leave meshes out.
Result<void> holds(const Scene& scene, ConversionReport& report, const std::filesystem::path& output)
{
    const formats::Format* format = formats::find(output);
    if (scene.meshes().empty() || format == nullptr || format->holdsMeshes)
        return {};
    if (scene.objects().empty())
        return failure("The model is a mesh, which " + format->name + " files do not hold here",
                       "Choose .knotspan, or a format of meshes");
    note(report, std::to_string(scene.meshes().size()) +
                     (scene.meshes().size() == 1 ? " mesh was" : " meshes were") + " left out: written as " +
                     format->name + ", the model is its surfaces.");
    return {};
}

// Whoever reads the file takes its numbers for millimetres, most likely.
void noteUnits(const Scene& scene, ConversionReport& report, bool isUnitLost)
{
    if (isUnitLost && scene.units() != "mm")
        note(report, "The file names no unit of length: its numbers are in " + scene.units() + ".");
}

// Who converts a file into itself has nothing to go back to.
Result<void> isAnotherFile(const Conversion& conversion)
{
    std::error_code error;
    if (std::filesystem::equivalent(conversion.input, conversion.output, error))
        return failure("This is the file that is read", "Choose another name");
    return {};
}

Result<void> write(Scene scene, const Conversion& conversion, const ConvertOptions& options,
                   ConversionReport& report)
{
    const std::filesystem::path& output = conversion.output;
    const bool isMesh = scene.objects().empty() && !scene.meshes().empty();
    if (const auto kind = isMesh ? formats::meshKindOf(output) : meshKindOf(output, options)) {
        return formats::exportMesh(scene, output,
                                   {*kind, options.deviation, options.angleDegrees, options.verify})
            .map([&](formats::MeshExportReport&& mesh) {
                for (const std::string& sentence : mesh.notes)
                    note(report, sentence);
                noteUnits(scene, report, *kind != formats::MeshKind::glb);
                report.isMeshVerified = options.verify;
                report.mesh = std::move(mesh);
            });
    }
    if (auto possible = holds(scene, report, output); !possible)
        return possible;
    const formats::Format* format = formats::find(output);
    noteUnits(scene, report, format != nullptr && !format->namesUnits);
    if (!options.verify)
        return formats::write(scene, output);
    return formats::writeVerified(scene, output).map([&](const formats::SceneDifference& difference) {
        report.largestDifference = difference.largest();
    });
}

// Places in sentences are as the user named them.
Error named(Error error, const Conversion& conversion, const ConversionReport& report)
{
    for (const auto& [path, name] : {std::pair{conversion.input.string(), report.input},
                                     std::pair{conversion.output.string(), report.output}})
        if (error.where.rfind(path, 0) == 0)
            error.where.replace(0, path.size(), name);
    return error.where.empty() ? error.at(report.output) : error;
}

}  // namespace

std::optional<formats::MeshKind> meshKindOf(const std::filesystem::path& output,
                                            const ConvertOptions& options)
{
    const auto kind = formats::meshKindOf(output);
    if (kind == formats::MeshKind::obj && !(options.deviation > 0) && !options.angleDegrees)
        return std::nullopt;
    return kind;
}

ConversionReport convert(const Conversion& conversion, const ConvertOptions& options)
{
    const auto start = std::chrono::steady_clock::now();
    ConversionReport report;
    report.input = conversion.inputName.empty() ? conversion.input.string() : conversion.inputName;
    report.output = conversion.outputName.empty() ? conversion.output.string() : conversion.outputName;
    const auto done = isAnotherFile(conversion).and_then([&]() -> Result<void> {
        auto import = readImport(conversion.input, report.input);
        if (!import)
            return tl::unexpected(import.error());
        if (import->report.faces > 0)
            report.import = import->report;
        report.notes = import->notes;
        return write(std::move(import->scene), conversion, options, report);
    });
    if (!done)
        report.error = named(done.error(), conversion, report);
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    report.peakMebibytes = peakMebibytes();
    return report;
}

}  // namespace knotspan::app
