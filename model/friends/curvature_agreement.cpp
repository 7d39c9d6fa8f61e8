#include "model/friends/curvature_agreement.h"

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

CurvatureAgreement curvatureAgreement(std::vector<FormPiece> pieces, const CurvatureLimits& limits)
{
    CurvatureAgreement result;
    double worst = -1;
    const auto note = [&](const FormPiece& piece, const Vec4& figures, double tau) {
        const Excess excess = excessAt(figures, limits);
        result.difference = std::max(result.difference, excess.difference);
        if (excess.share > worst) {
            worst = excess.share;
            result.part = piece.part;
            result.tau = tau;
        }
    };
    const auto noteEnds = [&](const FormPiece& piece) {
        note(piece, piece.form.front(), piece.from);
        note(piece, piece.form.back(), piece.to);
    };
    for (const FormPiece& piece : pieces)
        noteEnds(piece);
    const size_t mostHalvings = 300 + 8 * pieces.size();
    for (size_t halvings = 0; !pieces.empty();) {
        const bool first = pieces.back().from == 0.0 && pieces.back().to == 1.0;
        if (!first && worst > 1)
            pieces.pop_back();  // each part is looked at in its middle as well
        else if (agrees(pieces.back().form, limits) && !first)
            pieces.pop_back();
        else if (++halvings > mostHalvings)
            return result;
        else {
            FormPiece second = pieces.back().halved();
            noteEnds(second);
            pieces.push_back(std::move(second));
        }
    }
    result.certain = worst <= 1;
    return result;
}

}  // namespace knotspan
