// The statements of an OBJ file's text, word by word: lines that a backslash continues, comments, and line
// ends of any system.
#pragma once

#include <string_view>

#include "model/core/result.h"

namespace knotspan::formats {

// The text has to outlive this, and the words point into it.
class TextStatements {
public:
    explicit TextStatements(std::string_view text) : text_(text) { skipMark(); }

    // The first word of the next statement, whatever is left of this one; empty at the end of the text.
    [[nodiscard]] std::string_view next();
    // The next word of the statement; empty at its end.
    [[nodiscard]] std::string_view word();
    // What is left of the line, without the blanks around it: a name, which may contain anything.
    [[nodiscard]] std::string_view rest();

    // The line that was read last, from 1 on.
    [[nodiscard]] int line() const { return line_; }

    // These throw an Error that names the line: a word that is no number; fewer numbers than needed.
    [[nodiscard]] double number(const char* what);
    [[nodiscard]] double numberOf(std::string_view word, const char* what) const;
    [[nodiscard]] std::string_view needed(const char* what);
    [[noreturn]] void refuse(const std::string& why) const { refuseAt(line_, why); }
    [[noreturn]] static void refuseAt(int line, const std::string& why);

private:
    [[nodiscard]] size_t lineEndAt(size_t at) const;  // its length; 0 where there is none
    void skipMark();                                  // some programs begin UTF-8 with one
    void skipLine();

    std::string_view text_;
    size_t at_ = 0;
    int line_ = 1;
    bool begun_ = false;  // with the first statement
};

}  // namespace knotspan::formats
