#include "ui/viewport/view_cube.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "ui/viewport/stroke_text.h"

namespace knotspan {

namespace {

// In the hand's pixels.
constexpr double kHalfPx = 30;        // half a side, seen straight on
constexpr double kMarginPx = 58;      // from the view's corner to the middle: half a diagonal and some air
constexpr double kLeastViewPx = 240;  // smaller views have none
constexpr double kRim = 0.62;         // of half a side: further out are the edges and the corners

struct Face {
    Vec3 out;
    Vec3 right;  // as the name on it is read
    std::string_view name;
};
const std::array<Face, 6> kFaces{{{{0, -1, 0}, {1, 0, 0}, "FRONT"},
                                  {{0, 1, 0}, {-1, 0, 0}, "BACK"},
                                  {{-1, 0, 0}, {0, -1, 0}, "LEFT"},
                                  {{1, 0, 0}, {0, 1, 0}, "RIGHT"},
                                  {{0, 0, 1}, {1, 0, 0}, "TOP"},
                                  {{0, 0, -1}, {1, 0, 0}, "BOTTOM"}}};

class Placed {
public:
    explicit Placed(const CubePicture& picture)
        : right_(picture.camera.right()),
          up_(picture.camera.upward()),
          back_(-picture.camera.forward()),
          half_(kHalfPx * picture.pixelRatio),
          middle_(picture.width - kMarginPx * picture.pixelRatio, kMarginPx * picture.pixelRatio),
          fits_(std::min(picture.width, picture.height) >= kLeastViewPx * picture.pixelRatio)
    {
    }

    [[nodiscard]] bool fits() const { return fits_; }
    [[nodiscard]] double half() const { return half_; }
    [[nodiscard]] bool shows(const Face& face) const { return glm::dot(face.out, back_) > 1e-6; }
    // Of a point of the cube from -1 to 1: without perspective.
    [[nodiscard]] Vec2 pixel(const Vec3& point) const { return middle_ + direction(point); }
    [[nodiscard]] Vec2 direction(const Vec3& way) const
    {
        return Vec2(glm::dot(way, right_), -glm::dot(way, up_)) * half_;
    }
    // Where the line of sight through a pixel meets the plane of a face.
    [[nodiscard]] Vec3 onFace(const Vec2& pixel, const Face& face) const
    {
        const Vec2 offset = (pixel - middle_) / half_;
        const Vec3 near = right_ * offset.x - up_ * offset.y;
        return near + back_ * ((1 - glm::dot(near, face.out)) / glm::dot(back_, face.out));
    }

private:
    Vec3 right_;
    Vec3 up_;
    Vec3 back_;
    double half_;
    Vec2 middle_;
    bool fits_;
};

// A piece of a face: [fromA, toA] x [fromB, toB] along `right` and what is up on it.
struct Piece {
    const Face& face;
    double fromA, toA, fromB, toB;
};

Patch patchOf(const Placed& placed, const Piece& piece, std::uint32_t colour, float opacity)
{
    const Vec3 up = glm::cross(piece.face.out, piece.face.right);
    const auto corner = [&](double a, double b) {
        return placed.pixel(piece.face.out + piece.face.right * a + up * b);
    };
    return {{corner(piece.fromA, piece.fromB), corner(piece.toA, piece.fromB), corner(piece.toA, piece.toB),
             corner(piece.fromA, piece.toB)},
            colour,
            opacity};
}

// The stretch of a face that belongs to a part whose number along an axis of the face is `sign`.
std::pair<double, double> stretch(double sign)
{
    if (sign == 0)
        return {-kRim, kRim};
    return sign > 0 ? std::pair(kRim, 1.0) : std::pair(-1.0, -kRim);
}

void addName(std::vector<Stroke>& strokes, const Placed& placed, const Face& face)
{
    constexpr double kHeight = 0.3;  // of half a side
    const Vec3 up = glm::cross(face.out, face.right);
    const double unit = 1 / placed.half();
    const double height = kHeight * placed.half();
    const double width = strokeTextWidth(face.name, height);
    const Vec3 corner = face.out - face.right * (0.5 * width * unit) + up * (0.5 * height * unit);
    const double facing =
        glm::length(placed.direction(face.right)) * glm::length(placed.direction(up)) * unit * unit;
    if (facing < 0.2)
        return;  // too oblique to read
    addStrokeText(strokes, face.name,
                  {placed.pixel(corner), placed.direction(face.right) * unit, placed.direction(-up) * unit},
                  {.height = height, .width = 0.045 * placed.half(), .colour = 0x20242b, .halo = 0xd3d8e0});
}

}  // namespace

std::optional<CubePart> cubePartAt(const Vec2& pixel, const CubePicture& picture)
{
    const Placed placed(picture);
    if (!placed.fits())
        return std::nullopt;
    for (const Face& face : kFaces) {
        if (!placed.shows(face))
            continue;
        const Vec3 at = placed.onFace(pixel, face);
        Vec3 part = face.out;
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis) {
            if (face.out[axis] != 0)
                continue;
            inside = inside && std::abs(at[axis]) <= 1;
            if (std::abs(at[axis]) > kRim)
                part[axis] = at[axis] > 0 ? 1 : -1;
        }
        if (inside)
            return part;
    }
    return std::nullopt;
}

void addViewCube(Overlays& overlays, const CubePicture& picture, const std::optional<CubePart>& hovered)
{
    constexpr std::uint32_t kLight = 0xd3d8e0;
    constexpr std::uint32_t kLit = 0xff9a5c;
    constexpr std::uint32_t kEdge = 0x20242b;
    const Placed placed(picture);
    if (!placed.fits())
        return;
    for (const Face& face : kFaces) {
        if (!placed.shows(face))
            continue;
        overlays.patches.push_back(patchOf(placed, {face, -1, 1, -1, 1}, kLight, 0.92F));
        if (hovered && glm::dot(*hovered, face.out) > 0) {
            const Vec3 up = glm::cross(face.out, face.right);
            const auto [fromA, toA] = stretch(glm::dot(*hovered, face.right));
            const auto [fromB, toB] = stretch(glm::dot(*hovered, up));
            overlays.patches.push_back(patchOf(placed, {face, fromA, toA, fromB, toB}, kLit, 1));
        }
        const Patch whole = patchOf(placed, {face, -1, 1, -1, 1}, kEdge, 1);
        for (size_t k = 0; k < 4; ++k)
            overlays.strokes.push_back({whole.corners[k], whole.corners[(k + 1) % 4], kEdge,
                                        static_cast<float>(1.5 * picture.pixelRatio),
                                        static_cast<float>(1.5 * picture.pixelRatio), 1});
        addName(overlays.strokes, placed, face);
    }
}

Camera lookedFrom(const CubePart& part, Camera camera)
{
    const double distance = camera.distance();
    const Vec3 out = glm::normalize(part);
    // Straight from above and from below as the named views have it.
    if (part.x == 0 && part.y == 0)
        camera.up = part.z > 0 ? Vec3(0, 1, 0) : Vec3(0, -1, 0);
    else
        camera.up = {0, 0, 1};
    camera.eye = camera.target + out * distance;
    return camera;
}

}  // namespace knotspan
