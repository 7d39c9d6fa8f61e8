// Texts in STEP files: ISO 10303-21 knows ASCII, and escapes for everything else.
//
// OpenCASCADE's writer doubles the escapes' backslashes and breaks long texts in the middle of characters. So
// the model holds short stand-ins, and the texts take their places as the lines go to the file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace knotspan::formats {

// The UTF-8 text between apostrophes, in ASCII: 'R\X2\00FC\X0\ckwand'. Control characters become blanks.
[[nodiscard]] std::string stepText(std::string_view utf8);

class StepTexts {
public:
    // What stands for the text until textsIn() puts it there.
    [[nodiscard]] std::string standInFor(std::string_view utf8);
    [[nodiscard]] std::string replacedIn(std::string line) const;

private:
    std::vector<std::string> texts_;  // as stepText() makes them
};

}  // namespace knotspan::formats
