// Trimmed surfaces of closed forms in pictures of each path.
#pragma once

#include <functional>

#include "tests/pixels/trimmed_forms.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {

class TrimmedPictures : public ::testing::TestWithParam<PathId> {
protected:
    static constexpr int kWidth = 160;
    static constexpr int kHeight = 120;

    void SetUp() override
    {
        renderer = sharedRenderer();
        if (renderer == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        KNOTSPAN_NEED_PATH(*renderer, GetParam());
    }

    [[nodiscard]] Frame frameFor(const Scene& scene) const
    {
        return frameOf(scene, GetParam(), kWidth, kHeight);
    }

    // What the exact surface shows at a place in the picture: nothing, or the number of the layer.
    using Shown = std::function<int(const Ray&)>;

    // Every pixel whose neighbours would show the same, too.
    void expectShown(const Scene& scene, const Frame& frame, const Shown& shown)
    {
        const Drawn picture = drawn(*renderer, scene, frame);
        const KsQuadIndices indices = renderer->captureKsQuads().value();
        int judged = 0;
        int holes = 0;
        int wrong = 0;
        for (int y = 1; y + 1 < kHeight; ++y)
            for (int x = 1; x + 1 < kWidth; ++x) {
                const int wanted = shown(rayThrough(frame, x + 0.5, y + 0.5));
                bool alike = true;
                for (int k = 0; k < 9; ++k)
                    alike = alike && shown(rayThrough(frame, x - 0.5 + k % 3, y - 0.5 + k / 3)) == wanted;
                if (!alike)
                    continue;
                ++judged;
                holes += wanted == 0 ? 1 : 0;
                const bool there = indices.indices[static_cast<size_t>(y) * kWidth + x] != 0;
                wrong += there != (wanted != 0) || isBackground(picture.picture, x, y) == there ? 1 : 0;
            }
        EXPECT_EQ(wrong, 0);
        EXPECT_GT(judged, kWidth * kHeight / 2);
        EXPECT_GT(holes, 100);
    }

    static Shown layers(std::vector<Vec3> (*met)(const Ray&), const std::function<bool(const Vec3&)>& remains)
    {
        return [met, remains](const Ray& ray) {
            int layer = 0;
            for (const Vec3& place : met(ray)) {
                ++layer;
                if (remains(place))
                    return layer;
            }
            return 0;
        };
    }

    Renderer* renderer = nullptr;
};

inline Scene sceneOf(SceneObject object)
{
    Scene scene;
    scene.add(std::move(object));
    return scene;
}

}  // namespace knotspan::testing
