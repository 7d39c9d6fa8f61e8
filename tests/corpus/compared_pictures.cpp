#include "tests/corpus/compared_pictures.h"

#include <algorithm>
#include <fstream>
#include <map>

#include "model/formats/format_list.h"
#include "model/geometry/ksquad.h"
#include "tests/corpus/picture_comparison.h"

namespace knotspan::corpus {
namespace {

constexpr int kWidth = 800;
constexpr int kHeight = 600;
constexpr double kFineness = 1.0 / 16000;  // of the diagonal: about a twentieth of a pixel
constexpr double kDepthSlackPx = 3;

struct View {
    const char* name;
    bool orthographic;
};
constexpr View kViews[] = {{"front", true}, {"back", true},   {"left", true}, {"right", true},
                           {"top", true},   {"bottom", true}, {"iso", false}};

std::vector<Vec3> cornersOf(const Box& box)
{
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; ++k)
        corners.emplace_back((k & 1) != 0 ? box.high.x : box.low.x, (k & 2) != 0 ? box.high.y : box.low.y,
                             (k & 4) != 0 ? box.high.z : box.low.z);
    return corners;
}

// The object of each KSQuad, as KsQuadIndices counts them.
std::vector<int> objectsOfKsQuads(const Scene& scene)
{
    std::vector<int> objects;
    int number = 0;
    for (const auto& [id, object] : scene.objects())
        objects.insert(objects.end(), ksQuadCount(object->surface), number++);
    return objects;
}

// Which face of the file each object is: in the same order, but for those that we left out. Then an object is
// the face that most often shows where it shows.
class FaceNumbers {
public:
    FaceNumbers(size_t objects, int faces) : inOrder_(objects == static_cast<size_t>(faces)), votes_(objects)
    {
    }

    [[nodiscard]] bool needVotes() const { return !inOrder_; }
    void vote(int object, int face) { ++votes_[static_cast<size_t>(object)][face]; }

    [[nodiscard]] int of(int object) const
    {
        if (inOrder_)
            return object;
        const auto& votes = votes_[static_cast<size_t>(object)];
        const auto most = std::max_element(votes.begin(), votes.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        return most == votes.end() ? 0 : most->first;
    }

private:
    bool inOrder_;
    std::vector<std::map<int, int>> votes_;
};

struct TwoPictures {
    View view;
    ShownFaces objects;  // objects of the scene in the place of faces
    LayeredPicture theirs;
    double unitsPerPixel;
};

std::uint32_t colourOf(int face)
{
    if (face < 0)
        return 0x000000;
    const std::uint32_t mixed = (static_cast<std::uint32_t>(face) + 1) * 2654435761U;
    return 0x404040 + (mixed >> 8 & 0x7f7f7f);
}

void writePicture(const std::filesystem::path& path, const ShownFaces& ours, const LayeredPicture& theirs,
                  const PictureDifference& difference)
{
    static constexpr std::uint32_t kFaultColours[] = {0, 0xff2020, 0x3060ff, 0xff00ff, 0x20ff20, 0xffe000};
    std::ofstream file(path, std::ios::binary);
    file << "P6 " << 3 * kWidth << ' ' << kHeight << " 255\n";
    const auto put = [&](std::uint32_t colour) {
        for (const int shift : {16, 8, 0})
            file.put(static_cast<char>(colour >> shift & 0xff));
    };
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x)
            put(colourOf(ours.at(x, y)));
        for (int x = 0; x < kWidth; ++x)
            put(colourOf(theirs.covered(x, y) ? theirs.at(x, y).begin()->face : -1));
        for (int x = 0; x < kWidth; ++x) {
            const Fault fault = difference.faults[static_cast<size_t>(y) * kWidth + static_cast<size_t>(x)];
            put(fault != Fault::none ? kFaultColours[static_cast<size_t>(fault)]
                                     : (theirs.covered(x, y) ? 0x383838U : 0U));
        }
    }
}

Result<ShownFaces> objectsShown(Renderer& renderer, const Frame& frame, const std::vector<int>& objects)
{
    if (const auto drawn = renderer.draw(frame); !drawn)
        return tl::unexpected(drawn.error());
    const auto shown = renderer.captureKsQuads();
    if (!shown)
        return tl::unexpected(shown.error());
    ShownFaces faces{shown->width, shown->height, {}};
    for (const std::uint32_t index : shown->indices)
        faces.faces.push_back(index == 0 ? -1 : objects.at(index - 1));
    return faces;
}

class FileComparison {
public:
    FileComparison(Renderer& renderer, const ModelFile& file) : renderer_(renderer)
    {
        result_.corpus = file.corpus;
        result_.file = file.name;
        result_.format = cadFormatOf(file);
    }

    ComparedFile run(const std::filesystem::path& path, const std::optional<std::filesystem::path>& pictures)
    {
        const formats::Format* format = formats::find(path);
        const auto import = format->readIsolated(path, {});  // a test may crash
        if (!import)
            return unread(import.error());
        const auto mesh = fineMeshOf(path, kFineness);
        if (!mesh)
            return unread(mesh.error());
        result_.faces = mesh->faces;
        result_.untrimmed = import->report.untrimmed;
        result_.refused = import->report.refused;
        result_.unmeshed = static_cast<int>(mesh->unmeshed.size());
        for (const auto& [id, object] : import->scene.objects())
            result_.trimmed += object->trimLoops.empty() ? 0 : 1;
        if (const auto synced = renderer_.sync(import->scene); !synced)
            return unread(synced.error());
        const std::vector<int> objects = objectsOfKsQuads(import->scene);
        std::vector<TwoPictures> views;
        for (const View& view : kViews) {
            auto both = look(view, *mesh, objects);
            if (!both)
                return unread(both.error());
            views.push_back(std::move(*both));
        }
        judge(views, FaceNumbers(import->scene.objects().size(), mesh->faces), *mesh, pictures);
        return result_;
    }

private:
    ComparedFile unread(const Error& why)
    {
        result_.unread = why.sentence();
        return result_;
    }

    [[nodiscard]] Result<TwoPictures> look(const View& view, const FineMesh& mesh,
                                           const std::vector<int>& objects)
    {
        Frame frame;
        frame.width = kWidth;
        frame.height = kHeight;
        frame.path = renderer_.bestPath();
        frame.culling = defaultCulling();
        frame.camera = namedView(view.name, cornersOf(mesh.box), static_cast<double>(kWidth) / kHeight,
                                 view.orthographic)
                           .value();
        auto ours = objectsShown(renderer_, frame, objects);
        if (!ours)
            return tl::unexpected(ours.error());
        return TwoPictures{view, std::move(*ours), LayeredPicture(mesh, frame.camera, kWidth, kHeight),
                           frame.camera.unitsPerPixel(mesh.box.centre(), kHeight)};
    }

    void judge(std::vector<TwoPictures>& views, FaceNumbers numbers, const FineMesh& mesh,
               const std::optional<std::filesystem::path>& pictures)
    {
        if (numbers.needVotes())
            for (const TwoPictures& both : views)
                for (int y = 0; y < kHeight; ++y)
                    for (int x = 0; x < kWidth; ++x)
                        if (both.objects.at(x, y) >= 0 && both.theirs.covered(x, y))
                            numbers.vote(both.objects.at(x, y), both.theirs.at(x, y).begin()->face);
        const double slack = *std::max_element(mesh.slacks.begin(), mesh.slacks.end());
        for (TwoPictures& both : views) {
            for (int& face : both.objects.faces)
                face = face < 0 ? face : numbers.of(face);
            const PictureDifference difference =
                differenceOf(both.objects, both.theirs, kDepthSlackPx * both.unitsPerPixel + slack);
            take(both.view, difference);
            result_.slackPx = std::max(result_.slackPx, slack / both.unitsPerPixel);
            if (pictures &&
                (difference.offSilhouette + difference.otherFaces + difference.gaps + difference.leaks > 0))
                writePicture(*pictures / (nameForPicture() + "-" + both.view.name + ".ppm"), both.objects,
                             both.theirs, difference);
        }
    }

    void take(const View& view, const PictureDifference& difference)
    {
        if (difference.ratio() > result_.worst || result_.worstView.empty()) {
            result_.worst = difference.ratio();
            result_.worstView = view.name;
        }
        result_.silhouette += difference.silhouette;
        result_.unlike += difference.unlike;
        result_.gaps += difference.gaps;
        result_.leaks += difference.leaks;
        result_.wide += difference.wide;
        result_.otherFaces += difference.otherFaces;
        result_.shown += difference.shown;
    }

    [[nodiscard]] std::string nameForPicture() const
    {
        std::string name = result_.corpus + "-" + result_.file;
        std::replace(name.begin(), name.end(), '/', '_');
        return name;
    }

    Renderer& renderer_;
    ComparedFile result_;
};

}  // namespace

ComparedFile comparedPictures(Renderer& renderer, const ModelFile& file,
                              const std::optional<std::filesystem::path>& pictures)
{
    return FileComparison(renderer, file).run(file.path, pictures);
}

}  // namespace knotspan::corpus
