// How coarse pictures may be while the hand moves, so that they come 60 times a second.
//
// How to use it: while the hand drags or turns the view, tell afterDrawing() of each frame, from the start
// of its draw() to its end, and draw the next one with the answer. When the hand rests, rest() and draw once
// more with the tolerance that was asked for. Frames of before the gesture are not told.
//
//     frame.tolerancePx = pace.afterDrawing({frame.tolerancePx, milliseconds}, asked);
//
// It learns by trying. A looser tolerance that makes frames no faster, because pixels and not triangles cost
// the time, is taken back and not tried again before the next rest.
#pragma once

#include <optional>
#include <vector>

namespace knotspan {

class Pace {
public:
    static constexpr double kFrameMs = 1000.0 / 60;
    static constexpr double kLoosestPx = 8;

    struct Drawn {
        double tolerancePx = 0;  // that the frame was drawn with
        double ms = 0;           // that it took, waiting included
    };
    // The tolerance of the next frame: never finer than the asked one, and no coarser than 8 px or that.
    [[nodiscard]] double afterDrawing(const Drawn& drawn, double askedPx);

    void rest() { *this = {}; }

private:
    // What is taken back where it gains nothing.
    struct Trial {
        double beforePx = 0;
        double beforeMs = 0;
    };

    void changeTo(double tolerancePx);
    void judge(const Trial& trial);
    void loosen();
    void tighten();

    double askedPx_ = 0;
    double tolerancePx_ = 0;
    double loosestPx_ = 0;       // that is worth trying
    std::vector<double> times_;  // of the latest frames at this tolerance
    std::optional<Trial> trial_;
};

}  // namespace knotspan
