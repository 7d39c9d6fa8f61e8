#include "model/formats/import_lines.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "model/files/json_parsing.h"
#include "model/formats/knotspan_json.h"

namespace knotspan::formats {
namespace {

using Json = nlohmann::json;

std::string lineOf(const char* word, const Json& json)
{
    return std::string(word) + ' ' + json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

Json jsonOf(const ImportReport& report)
{
    Json refusals = Json::array();
    for (const RefusedFace& face : report.refusals)
        refusals.push_back({{"name", face.name}, {"reason", face.reason}});
    return {{"faces", report.faces},
            {"exact", report.exact},
            {"approximated", report.approximated},
            {"refused", report.refused},
            {"untrimmed", report.untrimmed},
            {"approximation_error", report.approximationError},
            {"refusals", std::move(refusals)},
            {"file_units", report.fileUnits},
            {"peak_bytes", report.peakBytes}};
}

// Throws what nlohmann throws where a member is missing or of another type.
ImportReport reportOf(const Json& json)
{
    ImportReport report;
    report.faces = json.at("faces").get<int>();
    report.exact = json.at("exact").get<int>();
    report.approximated = json.at("approximated").get<int>();
    report.refused = json.at("refused").get<int>();
    report.untrimmed = json.at("untrimmed").get<int>();
    report.approximationError = json.at("approximation_error").get<double>();
    for (const Json& face : json.at("refusals"))
        report.refusals.push_back({face.at("name").get<std::string>(), face.at("reason").get<std::string>()});
    report.fileUnits = json.at("file_units").get<std::string>();
    report.peakBytes = json.at("peak_bytes").get<std::uint64_t>();
    return report;
}

tl::unexpected<Error> rubbish()
{
    return failure("The importer gave an answer that is no model; nothing was changed",
                   "Export the file again from the program that made it");
}

// A sentence is one line, whoever wrote it.
std::string onOneLine(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c >= 0 && c < ' '; }, ' ');
    return text;
}

// Parsed with the limits of a file; throws nothing.
Result<Json> parsed(std::string_view text)
{
    auto json = parsedJson(std::string(text));
    if (!json || !json->is_object())
        return rubbish();
    return json;
}

}  // namespace

std::string progressLine(const std::string& stage, double done)
{
    return lineOf("progress", {{"stage", stage}, {"done", done}});
}

std::string objectLine(const SceneObject& object)
{
    return "object " + textOf(object) + '\n';
}

std::string meshLine(const MeshObject& mesh)
{
    return "mesh " + textOf(mesh) + '\n';
}

std::string endLine(const Import& import)
{
    return lineOf(
        "end", {{"units", import.scene.units()}, {"notes", import.notes}, {"report", jsonOf(import.report)}});
}

std::string errorLine(const Error& error)
{
    return lineOf("error", {{"what", error.what}, {"remedy", error.remedy}});
}

Result<void> ImportLines::take(std::string_view line)
{
    const size_t blank = std::min(line.find(' '), line.size());
    const std::string_view word = line.substr(0, blank);
    const std::string_view text = line.substr(std::min(blank + 1, line.size()));
    try {
        if (word == "object")
            return takeObject(text);
        if (word == "mesh")
            return takeMesh(text);
        if (word == "end")
            return takeEnd(text);
        const auto json = parsed(text);
        if (!json)
            return tl::unexpected(json.error());
        if (word == "progress") {
            const double done = json->at("done").get<double>();
            if (progress_)
                progress_(onOneLine(json->at("stage").get<std::string>()), std::min(done, 1.0));
            return {};
        }
        if (word == "error") {
            result_ = tl::unexpected<Error>({onOneLine(json->at("what").get<std::string>()),
                                             {},
                                             onOneLine(json->at("remedy").get<std::string>())});
            return {};
        }
    } catch (const Json::exception&) {
    }
    return rubbish();
}

// A model of what the line holds alone.
Result<Scene> ImportLines::sceneOf(const char* list, std::string_view text)
{
    auto element = parsed(text);
    if (!element)
        return tl::unexpected(element.error());
    Json model{{"format", "knotspan"}, {"version", 1}, {"units", "mm"}, {"objects", Json::array()}};
    model[list] = Json::array();
    model[list].push_back(std::move(*element));
    auto scene = sceneFromJson(model);
    if (!scene)
        return rubbish();
    return scene;
}

Result<void> ImportLines::takeObject(std::string_view text)
{
    const auto scene = sceneOf("objects", text);
    if (!scene)
        return tl::unexpected(scene.error());
    import_.scene.add(*scene->objects().begin()->second);
    return {};
}

Result<void> ImportLines::takeMesh(std::string_view text)
{
    const auto scene = sceneOf("meshes", text);
    if (!scene)
        return tl::unexpected(scene.error());
    import_.scene.addMesh(*scene->meshes().begin()->second);
    return {};
}

Result<void> ImportLines::takeEnd(std::string_view text)
{
    const auto json = parsed(text);
    if (!json)
        return tl::unexpected(json.error());
    import_.scene.setUnits(json->at("units").get<std::string>());
    import_.notes = json->at("notes").get<std::vector<std::string>>();
    import_.report = reportOf(json->at("report"));
    result_ = std::move(import_);
    return {};
}

}  // namespace knotspan::formats
