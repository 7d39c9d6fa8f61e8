#include "tests/corpus/record.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include <nlohmann/json.hpp>
#include <sys/wait.h>

namespace knotspan::corpus {
namespace {

using Json = nlohmann::json;

constexpr const char* kNames[] = {"read", "refused", "CRASHED", "HUNG", "STRANGE"};

// Reasons that differ in their numbers are one reason.
std::string withoutNumbers(const std::string& text)
{
    std::string plain;
    for (const char c : text)
        if (c < '0' || c > '9')
            plain += c;
        else if (plain.empty() || plain.back() != '#')
            plain += '#';
    return plain;
}

// One line, of which tabs are no part.
std::string cell(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\t' || c == '\n'; }, ' ');
    return text;
}

double diagonalOf(const Json& bounds)
{
    if (!bounds.is_object())
        return 0;
    double sum = 0;
    for (size_t axis = 0; axis < 3; ++axis)
        sum +=
            std::pow(bounds.at("high").at(axis).get<double>() - bounds.at("low").at(axis).get<double>(), 2);
    return std::sqrt(sum);
}

void takeReport(Record& record, const Json& report, double diagonal)
{
    record.faces = report.at("faces");
    record.exact = report.at("exact");
    record.approximated = report.at("approximated");
    record.refused = report.at("refused");
    record.untrimmed = report.at("untrimmed");
    const double error = report.at("approximation_error");
    record.relativeError = diagonal > 0 ? error / diagonal : 0;
    for (const Json& face : report.at("refusals"))
        ++record.refusals[withoutNumbers(face.at("reason").get<std::string>())];
}

// What `info --json` says of a file that was read. Throws where it is not that.
void takeAnswer(Record& record, const std::string& output)
{
    const Json json = Json::parse(output);
    record.surfaces = json.at("surfaces").size();
    if (json.contains("meshes"))
        for (const Json& mesh : json.at("meshes"))
            record.triangles += mesh.at("triangles").get<std::uint64_t>();
    if (json.contains("import"))
        takeReport(record, json.at("import"), diagonalOf(json.at("bounds")));
}

std::string sentenceOf(const ProgramRun& run, const ModelFile& file)
{
    std::string sentence = run.messages.substr(0, run.messages.find('\n'));
    for (const std::string& prefix : {std::string("knotspan: "), file.path.string() + ": "})
        if (sentence.rfind(prefix, 0) == 0)
            sentence.erase(0, prefix.size());
    return sentence;
}

Outcome outcomeOf(Record& record, const ProgramRun& run)
{
    if (run.tookTooLong)
        return Outcome::hung;
    if (!WIFEXITED(run.status))
        return Outcome::crashed;
    if (WEXITSTATUS(run.status) == 1 && std::count(run.messages.begin(), run.messages.end(), '\n') == 1 &&
        run.output.empty())
        return Outcome::refused;
    if (WEXITSTATUS(run.status) != 0)
        return Outcome::strange;
    try {
        takeAnswer(record, run.output);
        return Outcome::read;
    } catch (const Json::exception&) {
        return Outcome::strange;
    }
}

}  // namespace

const char* nameOf(Outcome outcome)
{
    return kNames[static_cast<size_t>(outcome)];
}

Record recordOf(const ModelFile& file, const ProgramRun& run)
{
    Record record;
    record.corpus = file.corpus;
    record.file = file.name;
    record.leaked = run.leaked;
    record.seconds = run.seconds;
    record.computing = run.computing;
    record.peakMb = static_cast<double>(run.peakBytes) / 1e6;
    std::error_code ignored;
    record.bytes = std::filesystem::file_size(file.path, ignored);
    record.outcome = outcomeOf(record, run);
    record.sentence = sentenceOf(run, file);
    return record;
}

std::string headerLine()
{
    return "corpus\tfile\toutcome\tleaked\tseconds\tcpu_seconds\tpeak_mb\tbytes\tfaces\texact\t"
           "approximated\trefused\tuntrimmed\trelative_error\tsurfaces\ttriangles\tsentence\trefusals";
}

std::string lineOf(const Record& record)
{
    std::ostringstream line;
    line << record.corpus << '\t' << cell(record.file) << '\t' << nameOf(record.outcome) << '\t'
         << record.leaked << '\t' << std::fixed << std::setprecision(3) << record.seconds << '\t'
         << record.computing << '\t' << std::setprecision(1) << record.peakMb << '\t' << record.bytes << '\t'
         << record.faces << '\t' << record.exact << '\t' << record.approximated << '\t' << record.refused
         << '\t' << record.untrimmed << '\t' << std::scientific << std::setprecision(3)
         << record.relativeError << '\t' << record.surfaces << '\t' << record.triangles << '\t'
         << cell(record.sentence) << '\t'
         << Json(record.refusals).dump(-1, ' ', false, Json::error_handler_t::replace);
    return line.str();
}

std::optional<Record> recordFrom(const std::string& line)
{
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string one; std::getline(text, one, '\t');)
        cells.push_back(one);
    const auto* const outcome =
        std::find(std::begin(kNames), std::end(kNames), cells.size() > 2 ? cells[2] : "");
    if (cells.size() != 18 || outcome == std::end(kNames))
        return std::nullopt;
    try {
        return Record{cells[0],
                      cells[1],
                      static_cast<Outcome>(outcome - std::begin(kNames)),
                      std::stoi(cells[3]),
                      std::stod(cells[4]),
                      std::stod(cells[5]),
                      std::stod(cells[6]),
                      std::stoull(cells[7]),
                      std::stoi(cells[8]),
                      std::stoi(cells[9]),
                      std::stoi(cells[10]),
                      std::stoi(cells[11]),
                      std::stoi(cells[12]),
                      std::stod(cells[13]),
                      std::stoull(cells[14]),
                      std::stoull(cells[15]),
                      cells[16],
                      Json::parse(cells[17])};
    } catch (const std::exception&) {  // a line that was being written when the last run ended
        return std::nullopt;
    }
}

}  // namespace knotspan::corpus
