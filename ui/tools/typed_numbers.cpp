#include "ui/tools/typed_numbers.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace knotspan {

namespace {

constexpr size_t kLongest = 80;  // nobody means more

Result<double> numberOf(std::string_view text)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::result_out_of_range)
        return failure("\"" + std::string(text) + "\" is too large or too small", "Give another number");
    if (error != std::errc() || end != text.data() + text.size())
        return failure("\"" + std::string(text) + "\" is no number yet",
                       "Go on typing, or take signs back with Backspace");
    return value;
}

}  // namespace

bool TypedNumbers::type(char sign)
{
    constexpr std::string_view kSigns = "0123456789.-,= ";
    if (kSigns.find(sign) == std::string_view::npos)
        return false;
    if (text_.size() < kLongest)
        text_ += sign;
    return true;
}

bool TypedNumbers::erase()
{
    if (text_.empty())
        return false;
    text_.pop_back();
    return true;
}

Result<DragNumbers> TypedNumbers::numbers() const
{
    constexpr double kMost = 1e12;  // beyond, pictures are noise
    constexpr std::string_view kBetween = ", ";
    DragNumbers result;
    std::string_view rest = text_;
    while (!rest.empty() && rest.front() == ' ')
        rest.remove_prefix(1);
    if (!rest.empty() && rest.front() == '=') {
        result.absolute = true;
        rest.remove_prefix(1);
    }
    while (rest.find_first_not_of(kBetween) != std::string_view::npos) {
        const size_t begin = rest.find_first_not_of(kBetween);
        const size_t end = std::min(rest.find_first_of(kBetween, begin), rest.size());
        const auto number = numberOf(rest.substr(begin, end - begin));
        if (!number)
            return tl::unexpected(number.error());
        if (std::abs(*number) > kMost)
            return failure("Nothing is moved that far", "Type a number of less than thirteen digits");
        result.values.push_back(*number);
        rest.remove_prefix(end);
    }
    if (result.values.empty())
        return failure("No number is typed yet", "Go on typing, or take signs back with Backspace");
    if (result.values.size() > 3)
        return failure("Space has three directions", "Type no more than three numbers");
    return result;
}

std::optional<int> coordinateOf(DragAxis axis)
{
    switch (axis) {
    case DragAxis::x:
        return 0;
    case DragAxis::y:
        return 1;
    case DragAxis::z:
        return 2;
    default:
        return std::nullopt;
    }
}

Result<Vec3> movementBy(const DragNumbers& numbers, const Vec3& start)
{
    Vec3 by(0);
    for (size_t k = 0; k < numbers.values.size(); ++k) {
        const auto at = static_cast<int>(k);
        by[at] = numbers.absolute ? numbers.values[k] - start[at] : numbers.values[k];
    }
    return by;
}

Result<double> distanceBy(const DragNumbers& numbers, DragAxis axis, const Vec3& start)
{
    if (numbers.values.size() != 1)
        return failure("One number says how far along an axis", "Type one, with a point for its decimals");
    const double value = numbers.values.front();
    if (!numbers.absolute)
        return value;
    const auto coordinate = coordinateOf(axis);
    if (!coordinate)
        return failure("Places along U, V and N have no numbers",
                       "Leave out the \"=\", or choose X, Y or Z with its key");
    return value - start[*coordinate];
}

Result<double> singleOf(const DragNumbers& numbers)
{
    if (numbers.absolute)
        return failure("Angles and factors count from where things stand", "Leave out the \"=\"");
    if (numbers.values.size() != 1)
        return failure("One number says it", "Type one, with a point for its decimals");
    return numbers.values.front();
}

}  // namespace knotspan
