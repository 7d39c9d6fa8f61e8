#include "model/formats/bpt_format.h"

#include "model/files/text_file.h"
#include "model/files/text_statements.h"

namespace knotspan::formats {

namespace {

constexpr unsigned kMostMebibytes = 512;
constexpr std::int64_t kMostPatches = 1'000'000;

// Reads number by number, however they are spread over lines; throws Error, which sceneFromBpt() catches.
class BptReader {
public:
    explicit BptReader(std::string_view text) : words_(text), size_(text.size()) {}

    [[nodiscard]] Import read() &&
    {
        const std::int64_t count = whole("The number of patches", 1, kMostPatches);
        // A patch of the least degree has 2 + 12 numbers and as many blanks between them.
        if (static_cast<std::uint64_t>(count) > size_ / 28 + 1)
            words_.refuse("The file says that it has " + std::to_string(count) +
                          " patches, but it is too short for them");
        Import import;
        for (std::int64_t k = 1; k <= count; ++k)
            import.scene.add({"Patch " + std::to_string(k),
                              Colour{},
                              Mat4(1.0),
                              true,
                              patch("Patch " + std::to_string(k)),
                              {}});
        if (!next().empty())
            words_.refuse("There is more behind the " + std::to_string(count) +
                          " patches that the file says it has");
        return import;
    }

private:
    // Of this line or those after it.
    std::string_view next()
    {
        const std::string_view word = words_.word();
        return word.empty() ? words_.next() : word;
    }

    std::string_view needed(const std::string& what)
    {
        const std::string_view word = next();
        if (word.empty())
            words_.refuse("The file ends where " + what + " should stand");
        return word;
    }

    std::int64_t whole(const std::string& what, std::int64_t least, std::int64_t most)
    {
        const std::string_view word = needed(what);
        const auto value = integerIn(word);
        if (!value || *value < least || *value > most)
            words_.refuse(what + " is no whole number from " + std::to_string(least) + " to " +
                          std::to_string(most) + ", but " + quoted(word));
        return *value;
    }

    NurbsSurface patch(const std::string& name)
    {
        const auto degree = [&] {
            return static_cast<int>(whole(name + "'s degree", kMinDegree, kMaxDegree));
        };
        KnotVector u = KnotVector::clampedUniform(degree(), 1);
        KnotVector v = KnotVector::clampedUniform(degree(), 1);
        std::vector<ControlPoint> points(static_cast<size_t>(u.controlPointCount()) *
                                         static_cast<size_t>(v.controlPointCount()));
        for (ControlPoint& point : points)
            for (int axis = 0; axis < 3; ++axis)
                point.position[axis] = words_.numberOf(needed(name + "'s next coordinate"), "The coordinate");
        auto surface = NurbsSurface::create(std::move(u), std::move(v), std::move(points));
        if (!surface)
            words_.refuse(name + " is no surface: " + surface.error().what);
        return *std::move(surface);
    }

    TextStatements words_;
    size_t size_;
};

Result<Import> readBptFile(const std::filesystem::path& path)
{
    return wholeText(path, kMostMebibytes, "bpt").and_then([](const std::string& text) {
        return sceneFromBpt(text);
    });
}

}  // namespace

Result<Import> sceneFromBpt(std::string_view text)
{
    try {
        return BptReader(text).read();
    } catch (const Error& error) {
        return tl::unexpected(error);
    }
}

Format bptFormat()
{
    Format format{"Bezier patches", {"bpt"}, readBptFile, nullptr};
    format.namesUnits = false;
    return format;
}

}  // namespace knotspan::formats
