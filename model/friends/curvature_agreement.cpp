#include "model/friends/curvature_agreement.h"

#include <algorithm>
#include <cmath>

namespace knotspan {

namespace {

struct Excess {
    double difference = 0;
    double share = 0;  // of what is allowed; no more than 1 is agreement
};

Excess excessAt(const Vec4& figures, const CurvatureLimits& limits)
{
    const double scale = figures.z * std::sqrt(figures.w);
    if (!(scale > 0))
        return {};
    const double a = figures.x / scale;
    const double b = figures.y / scale / std::cos(limits.angle);
    const double larger = std::max({std::abs(a), std::abs(b), limits.least});
    return {std::abs(a - b), std::abs(a - b) / (limits.share * larger)};
}

// Whether the coefficients guarantee agreement over the piece.
bool agrees(const Form& form, const CurvatureLimits& limits)
{
    double difference = 0;
    double ofB = 0;
    double lowest[2] = {form[0].x / form[0].z, form[0].y / form[0].z};
    double highest[2] = {lowest[0], lowest[1]};
    double squares[2] = {form[0].w, form[0].w};
    for (const Vec4& figures : form) {
        if (!(figures.z > 0) || !(figures.w > 0))
            return false;
        const double quotients[] = {figures.x / figures.z, figures.y / figures.z};
        difference = std::max(difference, std::abs(figures.x - figures.y) / figures.z);
        ofB = std::max(ofB, std::abs(quotients[1]));
        for (const size_t k : {0U, 1U}) {
            lowest[k] = std::min(lowest[k], quotients[k]);
            highest[k] = std::max(highest[k], quotients[k]);
        }
        squares[0] = std::min(squares[0], figures.w);
        squares[1] = std::max(squares[1], figures.w);
    }
    const double beside = std::max({lowest[0], -highest[0], lowest[1], -highest[1], 0.0});
    const double larger = std::max(beside / std::sqrt(squares[1]), limits.least);
    const double turned = ofB * (1 / std::cos(limits.angle) - 1);
    return (difference + turned) / std::sqrt(squares[0]) <= limits.share * larger;
}

}  // namespace

std::optional<CurvatureAgreement> curvatureAgreement(size_t parts, const CurvatureForms& formOf,
                                                     const CurvatureLimits& limits)
{
    struct Piece {
        Form form;
        size_t part;
        double from;
        double to;
    };
    std::vector<Piece> pieces;
    for (size_t part = 0; part < parts; ++part) {
        auto form = formOf(part, 0, 1);
        if (!form)
            return std::nullopt;
        pieces.push_back({*std::move(form), part, 0, 1});
    }
    CurvatureAgreement result;
    double worst = -1;
    const auto note = [&](const Piece& piece, const Vec4& figures, double tau) {
        const Excess excess = excessAt(figures, limits);
        result.difference = std::max(result.difference, excess.difference);
        if (excess.share > worst) {
            worst = excess.share;
            result.part = piece.part;
            result.tau = tau;
        }
    };
    const auto noteEnds = [&](const Piece& piece) {
        note(piece, piece.form.front(), piece.from);
        note(piece, piece.form.back(), piece.to);
    };
    for (const Piece& piece : pieces)
        noteEnds(piece);
    const size_t mostHalvings = 300 + 8 * pieces.size();
    for (size_t halvings = 0; !pieces.empty();) {
        const Piece piece = std::move(pieces.back());
        pieces.pop_back();
        const bool whole = piece.from == 0.0 && piece.to == 1.0;
        // Each part is looked at in its middle as well.
        if (!whole && (worst > 1 || agrees(piece.form, limits)))
            continue;
        if (++halvings > mostHalvings)
            return result;
        const double middle = (piece.from + piece.to) / 2;
        auto first = formOf(piece.part, piece.from, middle);
        auto second = formOf(piece.part, middle, piece.to);
        if (!first || !second)
            return result;
        pieces.push_back({*std::move(first), piece.part, piece.from, middle});
        pieces.push_back({*std::move(second), piece.part, middle, piece.to});
        noteEnds(pieces.back());
    }
    result.certain = worst <= 1;
    return result;
}

}  // namespace knotspan
