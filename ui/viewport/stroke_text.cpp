#include "ui/viewport/stroke_text.h"

#include <array>

#include <glm/geometric.hpp>

namespace knotspan {

namespace {

// Lines from point to point of a grid, 4 wide and 6 high: its column and its row, from the upper left.
struct Glyph {
    char character;
    std::string_view lines;
};
constexpr std::array kGlyphs = std::to_array<Glyph>({
    {'A', "06 02 20 42 46,04 44"},
    {'B', "00 06 36 45 44 33 03,00 30 41 42 33"},
    {'C', "41 30 10 01 05 16 36 45"},
    {'D', "00 06 26 44 42 20 00"},
    {'E', "40 00 06 46,03 33"},
    {'F', "40 00 06,03 33"},
    {'G', "41 30 10 01 05 16 36 45 43 23"},
    {'H', "00 06,40 46,03 43"},
    {'I', "20 26"},
    {'J', "40 45 36 16 05"},
    {'K', "00 06,40 03 46"},
    {'L', "00 06 46"},
    {'M', "06 00 23 40 46"},
    {'N', "06 00 46 40"},
    {'O', "10 30 41 45 36 16 05 01 10"},
    {'P', "06 00 30 41 42 33 03"},
    {'Q', "10 30 41 45 36 16 05 01 10,24 46"},
    {'R', "06 00 30 41 42 33 03,23 46"},
    {'S', "41 30 10 01 02 13 33 44 45 36 16 05"},
    {'T', "00 40,20 26"},
    {'U', "00 05 16 36 45 40"},
    {'V', "00 26 40"},
    {'W', "00 16 23 36 40"},
    {'X', "00 46,40 06"},
    {'Y', "00 23 40,23 26"},
    {'Z', "00 40 06 46"},
    {'0', "10 30 41 45 36 16 05 01 10,14 32"},
    {'1', "11 20 26,16 36"},
    {'2', "01 10 30 41 42 06 46"},
    {'3', "01 10 30 41 42 33 44 45 36 16 05,33 23"},
    {'4', "36 30 04 44"},
    {'5', "40 00 03 33 44 45 36 06"},
    {'6', "41 30 10 01 05 16 36 45 44 33 03"},
    {'7', "00 40 16"},
    {'8', "10 30 41 42 33 13 02 01 10,13 04 05 16 36 45 44 33"},
    {'9', "05 16 36 45 41 30 10 01 02 13 43"},
    {'-', "13 33"},
    {'+', "03 43,21 25"},
    {'.', "25 26"},
    {'/', "06 40"},
    {':', "21 22,24 25"},
});
constexpr double kGridHeight = 6;
constexpr double kAdvance = 5.6;
constexpr double kLetterWidth = 4;
constexpr double kHaloPx = 1.5;  // on each side

std::string_view linesOf(char character)
{
    const char capital =
        character >= 'a' && character <= 'z' ? static_cast<char>(character - 'a' + 'A') : character;
    for (const Glyph& glyph : kGlyphs)
        if (glyph.character == capital)
            return glyph.lines;
    return {};
}

}  // namespace

double strokeTextWidth(std::string_view text, double height)
{
    if (text.empty())
        return 0;
    return (kAdvance * static_cast<double>(text.size() - 1) + kLetterWidth) * height / kGridHeight;
}

void addStrokeText(std::vector<Stroke>& to, std::string_view text, const StrokeTextPlace& place,
                   const StrokeTextStyle& style)
{
    const double unit = style.height / kGridHeight;
    const auto add = [&](std::uint32_t colour, double width) {
        for (size_t k = 0; k < text.size(); ++k) {
            const Vec2 left = place.corner + place.across * (kAdvance * static_cast<double>(k) * unit);
            std::optional<Vec2> last;
            const std::string_view lines = linesOf(text[k]);
            for (size_t at = 0; at + 1 < lines.size(); at += 3) {
                const Vec2 here = left + place.across * ((lines[at] - '0') * unit) +
                                  place.down * ((lines[at + 1] - '0') * unit);
                if (last && glm::length(here - *last) > 0) {
                    const Vec2 over = glm::normalize(here - *last) * (0.5 * style.width);  // whole corners
                    to.push_back({*last - over, here + over, colour, static_cast<float>(width),
                                  static_cast<float>(width), 1});
                }
                const bool ends = at + 2 < lines.size() && lines[at + 2] == ',';
                last = ends ? std::nullopt : std::optional(here);
            }
        }
    };
    add(style.halo, style.width + 2 * kHaloPx);
    add(style.colour, style.width);
}

}  // namespace knotspan
