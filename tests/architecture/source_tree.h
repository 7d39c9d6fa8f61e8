// The files of the source tree, as the checks of its shape see them.
#pragma once

#include <string>
#include <vector>

namespace knotspan::architecture {

// Paths from the root of the tree, with forward slashes, sorted: everything below the folders that hold code.
[[nodiscard]] std::vector<std::string> sourceFiles();
// The folders that hold code, at the top.
[[nodiscard]] const std::vector<std::string>& topFolders();
[[nodiscard]] std::string contentOf(const std::string& file);

[[nodiscard]] bool isCpp(const std::string& file);     // .cpp, .h
[[nodiscard]] bool isShader(const std::string& file);  // what glslc compiles, and what that includes

// A sentence where the path breaks a rule of naming: words of lower case letters, digits and underscores, and
// none of the words that say nothing (util, helper, manager, common). Empty where it is well named.
[[nodiscard]] std::string namingFault(const std::string& path);
// A sentence where the file lies too deep: folders go two deep; those of the tests mirror the tree.
[[nodiscard]] std::string depthFault(const std::string& path);

}  // namespace knotspan::architecture
