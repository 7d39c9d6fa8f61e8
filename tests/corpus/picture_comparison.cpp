#include "tests/corpus/picture_comparison.h"

#include <algorithm>
#include <limits>

namespace knotspan::corpus {
namespace {

class Comparison {
public:
    Comparison(const ShownFaces& ours, const LayeredPicture& theirs, double depthSlack)
        : ours_(ours),
          theirs_(theirs),
          depthSlack_(depthSlack)
    {
    }

    [[nodiscard]] PictureDifference difference() const
    {
        PictureDifference all;
        all.width = ours_.width;
        for (int y = 0; y < ours_.height; ++y)
            for (int x = 0; x < ours_.width; ++x) {
                const Fault fault = faultAt(x, y);
                all.faults.push_back(fault);
                all.shown += theirs_.covered(x, y) ? 1 : 0;
                all.unlike += (ours_.at(x, y) >= 0) != theirs_.covered(x, y) ? 1 : 0;
                all.silhouette += isSilhouette(x, y) ? 1 : 0;
                all.gaps += fault == Fault::gap ? 1 : 0;
                all.leaks += fault == Fault::leak ? 1 : 0;
                all.otherFaces += fault == Fault::otherFace ? 1 : 0;
                all.offSilhouette += fault == Fault::missing || fault == Fault::surplus ? 1 : 0;
            }
        all.wide = wideBlocks(all);
        return all;
    }

private:
    [[nodiscard]] static size_t wideBlocks(const PictureDifference& all)
    {
        const auto width = static_cast<size_t>(all.width);
        const auto opens = [&](size_t pixel) {
            const Fault fault = all.faults[pixel];
            return fault == Fault::gap || fault == Fault::leak || fault == Fault::otherFace;
        };
        size_t blocks = 0;
        for (size_t k = 0; k + width + 1 < all.faults.size(); ++k)
            blocks += opens(k) && opens(k + 1) && opens(k + width) && opens(k + width + 1) ? 1 : 0;
        return blocks;
    }

    // Whether one of the pixels around (x, y), itself included, is inside the picture and has it.
    template <class Predicate>
    [[nodiscard]] bool near(int x, int y, const Predicate& has) const
    {
        for (int k = 0; k < 9; ++k) {
            const int i = x - 1 + k % 3;
            const int j = y - 1 + k / 3;
            if (i >= 0 && j >= 0 && i < ours_.width && j < ours_.height && has(i, j))
                return true;
        }
        return false;
    }

    [[nodiscard]] bool isSilhouette(int x, int y) const
    {
        return theirs_.covered(x, y) && near(x, y, [&](int i, int j) { return !theirs_.covered(i, j); });
    }

    [[nodiscard]] Fault faultAt(int x, int y) const
    {
        const bool ours = ours_.at(x, y) >= 0;
        const bool theirs = theirs_.covered(x, y);
        const auto theirsIs = [&](bool covered) {
            return near(x, y, [&](int i, int j) { return theirs_.covered(i, j) == covered; });
        };
        const auto oursIs = [&](bool covered) {
            return near(x, y, [&](int i, int j) { return (ours_.at(i, j) >= 0) == covered; });
        };
        if (ours && theirs)
            return showsAFaceThatIsThere(x, y) ? Fault::none
                   : facesMeet(x, y)           ? Fault::leak
                                               : Fault::otherFace;
        if (!ours && theirs && !theirsIs(false))
            return Fault::gap;
        // The outlines pass within a pixel where each picture has nearby what the other has here.
        if (ours == theirs || (theirsIs(ours) && oursIs(theirs)))
            return Fault::none;
        return ours ? Fault::surplus : Fault::missing;
    }

    [[nodiscard]] bool facesMeet(int x, int y) const
    {
        const int front = theirs_.at(x, y).begin()->face;
        return near(x, y, [&](int i, int j) {
            return !theirs_.covered(i, j) || theirs_.at(i, j).begin()->face != front;
        });
    }

    [[nodiscard]] bool showsAFaceThatIsThere(int x, int y) const
    {
        const int shown = ours_.at(x, y);
        return near(x, y, [&](int i, int j) {
            const auto layers = theirs_.at(i, j);
            const double depth = layers.empty() ? std::numeric_limits<double>::infinity()
                                                : layers.begin()->depth + depthSlack_;
            return theirs_.onEdge(i, j, shown, depth) ||
                   std::any_of(layers.begin(), layers.end(), [&](const Layer& layer) {
                       return layer.face == shown && layer.depth <= depth;
                   });
        });
    }

    const ShownFaces& ours_;
    const LayeredPicture& theirs_;
    double depthSlack_;
};

}  // namespace

PictureDifference differenceOf(const ShownFaces& ours, const LayeredPicture& theirs, double depthSlack)
{
    return Comparison(ours, theirs, depthSlack).difference();
}

}  // namespace knotspan::corpus
