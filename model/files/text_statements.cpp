#include "model/files/text_statements.h"

#include "model/files/text_file.h"

namespace knotspan::formats {

namespace {

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

}  // namespace

size_t TextStatements::lineEndAt(size_t at) const
{
    if (at >= text_.size() || (text_[at] != '\n' && text_[at] != '\r'))
        return 0;
    return text_[at] == '\r' && at + 1 < text_.size() && text_[at + 1] == '\n' ? 2 : 1;
}

void TextStatements::skipMark()
{
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    if (text_.substr(0, kMark.size()) == kMark)
        text_.remove_prefix(kMark.size());
}

void TextStatements::skipLine()
{
    while (at_ < text_.size() && lineEndAt(at_) == 0)
        ++at_;
}

std::string_view TextStatements::word()
{
    const auto continuationAt = [this](size_t at) { return text_[at] == '\\' ? lineEndAt(at + 1) : 0; };
    for (; at_ < text_.size(); ++at_) {
        if (const size_t length = continuationAt(at_); length > 0) {
            at_ += length;
            ++line_;
        } else if (!isBlank(text_[at_])) {
            break;
        }
    }
    if (at_ < text_.size() && text_[at_] == '#')
        skipLine();
    const size_t start = at_;
    while (at_ < text_.size() && !isBlank(text_[at_]) && lineEndAt(at_) == 0 && continuationAt(at_) == 0)
        ++at_;
    return text_.substr(start, at_ - start);
}

std::string_view TextStatements::next()
{
    while (begun_ && !word().empty()) {
    }
    begun_ = true;
    while (at_ < text_.size()) {
        if (const size_t length = lineEndAt(at_); length > 0) {
            at_ += length;
            ++line_;
        } else if (const std::string_view first = word(); !first.empty()) {
            return first;
        }
    }
    return {};
}

std::string_view TextStatements::rest()
{
    while (at_ < text_.size() && isBlank(text_[at_]))
        ++at_;
    const size_t start = at_;
    skipLine();
    size_t end = at_;
    while (end > start && isBlank(text_[end - 1]))
        --end;
    return text_.substr(start, end - start);
}

std::string_view TextStatements::needed(const char* what)
{
    const int line = line_;
    const std::string_view found = word();
    if (found.empty())
        refuseAt(line, std::string(what) + " is missing");
    return found;
}

double TextStatements::number(const char* what)
{
    return numberOf(needed(what), what);
}

double TextStatements::numberOf(std::string_view found, const char* what) const
{
    const auto value = numberIn(found);
    if (!value)
        refuse(std::string(what) + " is no finite number, but " + quoted(found));
    return *value;
}

void TextStatements::refuseAt(int line, const std::string& why)
{
    throw Error{why, "line " + std::to_string(line), "Export or copy the model again"};
}

}  // namespace knotspan::formats
