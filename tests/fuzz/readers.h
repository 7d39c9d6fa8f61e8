// What the fuzz targets do with a text; the ordinary tests do the same with a few thousand of them.
#pragma once

#include <string>
#include <string_view>

namespace knotspan::fuzz {

// Each reads the text as a file of its format and stops the program where the model that came of it, once
// written and read again, has other surfaces. The sentence that refuses the text; empty where it is a model.
std::string readObj(std::string_view text);
std::string readBpt(std::string_view text);
std::string readKnotspan(std::string_view text);

}  // namespace knotspan::fuzz
