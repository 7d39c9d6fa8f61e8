// How a failure of the outside world (a file, an argument, a driver) travels to the user.
//
// Such failures are values: a function that can meet one returns Result<T>. Our own mistakes are not: they
// stop the program through check() of check.h.
#pragma once

#include <string>
#include <utility>

#include <tl/expected.hpp>

namespace knotspan {

// What failed, where, and what to do about it, in words for the user. Each part is a clause without a full
// stop; `where` and `remedy` may be empty.
struct Error {
    std::string what;
    std::string where;
    std::string remedy;

    // "WHERE: WHAT. REMEDY.", the parts that are empty left out.
    [[nodiscard]] std::string sentence() const;

    // The same error, said of `place` (a file's path, say); keeps a place that is already there behind it.
    [[nodiscard]] Error at(const std::string& place) const;
};

template <class T>
using Result = tl::expected<T, Error>;

// `return failure("The file is empty", "Choose another file");`
[[nodiscard]] inline tl::unexpected<Error> failure(std::string what, std::string remedy = {})
{
    return tl::unexpected<Error>(Error{std::move(what), {}, std::move(remedy)});
}

}  // namespace knotspan
