// The largest value of something along an edge, between what is attained and what coefficients guarantee.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/friends/bernstein_products.h"

namespace knotspan {

// A piece of a form: of matched part `part`, from tau = `from` to `to`.
struct FormPiece {
    Form form;
    size_t part = 0;
    double from = 0;
    double to = 1;
    double bound = 0;

    [[nodiscard]] FormPiece halved()  // keeps the first half
    {
        FormPiece second{{}, part, (from + to) / 2, to, 0};
        to = second.from;
        halve(form, second.form);
        return second;
    }
};

struct CertainMaximum {
    double attained = 0;
    double bound = 0;
    size_t part = 0;  // where it is attained; where it is not certain, if the limit lies between both
    double tau = 0;
};

// Halves the piece of the largest bound until that is within 1 % of what is attained, or no more than
// `small`, and on one side of `limit`; or gives up. value(Vec4): at a place; bound(Form): over a piece.
template <class Value, class Bound>
[[nodiscard]] CertainMaximum certainMaximum(std::vector<FormPiece> pieces, double limit, double small,
                                            const Value& value, const Bound& bound)
{
    CertainMaximum result;
    result.attained = -1;
    const auto look = [&](FormPiece& piece) {
        piece.bound = bound(piece.form);
        const double ends[] = {value(piece.form.front()), value(piece.form.back())};
        for (const size_t k : {0U, 1U})
            if (ends[k] > result.attained) {
                result.attained = ends[k];
                result.part = piece.part;
                result.tau = k == 0 ? piece.from : piece.to;
            }
    };
    const auto lower = [](const FormPiece& x, const FormPiece& y) { return x.bound < y.bound; };
    for (FormPiece& piece : pieces)
        look(piece);
    std::make_heap(pieces.begin(), pieces.end(), lower);
    const size_t mostPieces = 9 * pieces.size() + 1000;
    while (pieces.size() < mostPieces) {
        const double highest = pieces.front().bound;
        const bool near = highest <= std::max(1.01 * result.attained, small);
        if (near && !(result.attained <= limit && limit < highest))
            break;
        std::pop_heap(pieces.begin(), pieces.end(), lower);
        if (pieces.back().to - pieces.back().from < 1e-12) {
            std::push_heap(pieces.begin(), pieces.end(), lower);
            break;
        }
        FormPiece second = pieces.back().halved();
        look(pieces.back());
        look(second);
        std::push_heap(pieces.begin(), pieces.end(), lower);
        pieces.push_back(std::move(second));
        std::push_heap(pieces.begin(), pieces.end(), lower);
    }
    result.attained = std::max(result.attained, 0.0);
    result.bound = std::max(pieces.front().bound, result.attained);
    if (result.attained <= limit && limit < result.bound) {
        result.part = pieces.front().part;
        result.tau = (pieces.front().from + pieces.front().to) / 2;
    }
    return result;
}

}  // namespace knotspan
