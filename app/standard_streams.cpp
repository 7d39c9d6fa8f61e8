#include "app/standard_streams.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>

#include <unistd.h>

namespace knotspan::app {

namespace fs = std::filesystem;

StreamFolder::StreamFolder()
{
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "knotspan-XXXXXX").string();
    if (!error && ::mkdtemp(name.data()) != nullptr)
        path_ = name;
}

StreamFolder::~StreamFolder()
{
    std::error_code error;
    if (!path_.empty())
        fs::remove_all(path_, error);
}

Result<fs::path> StreamFolder::place(const std::string& extension) const
{
    if (path_.empty())
        return failure("No temporary folder can be made",
                       "Make room where TMPDIR is, or set it to another place");
    return path_ / ("standard-output." + extension);
}

Result<fs::path> StreamFolder::input(const std::string& extension) const
{
    if (path_.empty())
        return tl::unexpected(place(extension).error());
    const fs::path path = path_ / ("standard-input." + extension);
    std::ofstream file(path, std::ios::binary);
    std::array<char, 1 << 16> part;
    ssize_t count = 0;
    while ((count = ::read(STDIN_FILENO, part.data(), part.size())) > 0 || (count < 0 && errno == EINTR))
        if (count > 0 && !file.write(part.data(), count))
            break;
    file.close();
    if (count < 0)
        return failure(std::string("Standard input cannot be read: ") + std::strerror(errno));
    if (!file)
        return failure("Standard input is larger than the room for temporary files",
                       "Set TMPDIR to a place with more room");
    return path;
}

Result<void> sendToOutput(const fs::path& file)
{
    std::ifstream from(file, std::ios::binary);
    std::cout << from.rdbuf();
    if (!from || !std::cout.flush())
        return failure("Standard output cannot be written", "Check the place it goes to");
    return {};
}

}  // namespace knotspan::app
