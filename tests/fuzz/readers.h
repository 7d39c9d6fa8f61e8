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

// The same with the text as the list of trim loops of a .knotspan file's one surface; and, where it is none,
// as the trimming curves of an OBJ file's. What becomes a curve has points wherever it is asked.
std::string readTrimLoops(std::string_view text);

// Meshes: what was read has finite vertices, and triangles of three different ones of them.
std::string readStl(std::string_view text);
std::string readPly(std::string_view text);
std::string readOff(std::string_view text);
std::string readGltf(std::string_view text);

}  // namespace knotspan::fuzz
