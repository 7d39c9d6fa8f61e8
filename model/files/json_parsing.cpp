#include "model/files/json_parsing.h"

#include <algorithm>
#include <set>
#include <vector>

namespace knotspan::formats {

namespace {

using nlohmann::json;

constexpr int kDeepest = 16;

std::string placeIn(const std::string& text, size_t byte)
{
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
    const auto lineStart = std::find(std::make_reverse_iterator(end), text.rend(), '\n').base();
    return "line " + std::to_string(std::count(text.begin(), end, '\n') + 1) + ", column " +
           std::to_string(end - lineStart + 1);
}

// Watches the parser from inside its callback, before a value takes memory; throws Error, which ends the
// parsing.
class Limits {
public:
    explicit Limits(std::int64_t mostValues) : mostValues_(mostValues) {}

    bool see(int depth, json::parse_event_t event, const json& parsed)
    {
        using Event = json::parse_event_t;
        if (depth > kDeepest)
            throw Error{"Values are nested more than " + std::to_string(kDeepest) + " deep",
                        {},
                        "Choose another file: this is no Knotspan model"};
        if (++values_ > mostValues_)
            throw Error{"The file holds more than " + std::to_string(mostValues_) + " values",
                        {},
                        "Split the model into several files"};
        const auto level = static_cast<size_t>(depth);
        if (event == Event::object_start) {
            if (keys_.size() < level + 2)
                keys_.resize(level + 2);
            keys_[level + 1].clear();
        }
        if (event == Event::key && !keys_[level].insert(parsed.get<std::string>()).second)
            throw Error{"\"" + parsed.get<std::string>() + "\" stands twice in one place", {}, {}};
        return true;
    }

private:
    std::int64_t mostValues_;
    std::int64_t values_ = 0;
    std::vector<std::set<std::string>> keys_;  // of the object that is open at each depth
};

}  // namespace

Result<json> parsedJson(const std::string& text, std::int64_t mostValues)
{
    Limits limits(mostValues);
    try {
        return json::parse(text, [&](int depth, json::parse_event_t event, json& parsed) {
            return limits.see(depth, event, parsed);
        });
    } catch (const Error& error) {
        return tl::unexpected(error);
    } catch (const json::parse_error& error) {
        if (error.byte > text.size())
            return failure("The file ends in the middle of the model", "Use another copy of it");
        return failure("The file is damaged at " + placeIn(text, error.byte == 0 ? 0 : error.byte - 1),
                       "Use another copy of it");
    } catch (const json::out_of_range&) {
        return failure("The file has a number that is too large");
    }
}

}  // namespace knotspan::formats
