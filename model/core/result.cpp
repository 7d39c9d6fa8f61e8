#include "model/core/result.h"

namespace knotspan {

std::string Error::sentence() const
{
    std::string text = where.empty() ? what : where + ": " + what;
    text += '.';
    if (!remedy.empty())
        text += ' ' + remedy + '.';
    return text;
}

Error Error::at(const std::string& place) const
{
    return {what, where.empty() ? place : place + ", " + where, remedy};
}

}  // namespace knotspan
