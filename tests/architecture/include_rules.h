// Who may include whom: the table of docs/architecture.md, and the check of one file against it.
#pragma once

#include <string>
#include <vector>

namespace knotspan::architecture {

// What a folder may do with the disk. `names` is to carry paths about, without opening anything.
enum class Disk { no, names, yes };

// A folder of the tree and what its files may include beside each other.
struct FolderRule {
    std::string folder;                   // "model/core"
    std::vector<std::string> mayInclude;  // folders, with what is below them, and single headers
    Disk disk = Disk::no;
    // Libraries that only some folders may see.
    bool qt = false;
    bool vulkan = false;
    bool openCascade = false;
    bool meshLibraries = false;  // OpenMesh, VTK
};

[[nodiscard]] const std::vector<FolderRule>& folderRules();
// The rule of the folder that the file lies in; null where the table has none.
[[nodiscard]] const FolderRule* ruleFor(const std::string& file);

struct Include {
    std::string name;
    bool quoted = false;  // "name", not <name>

    [[nodiscard]] bool operator==(const Include&) const = default;
};

// What the #include lines of a file name, in their order.
[[nodiscard]] std::vector<Include> includesOf(const std::string& content);

// A sentence for each #include that the table forbids. `file` is the path from the root of the tree.
[[nodiscard]] std::vector<std::string> forbiddenIncludes(const std::string& file, const std::string& content);

}  // namespace knotspan::architecture
