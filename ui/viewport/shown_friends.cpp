#include "ui/viewport/shown_friends.h"

#include <cmath>

#include "ui/viewport/friend_lines.h"

namespace knotspan {

ShownFriends::ShownFriends(DocumentFriends& friends, QObject* parent) : QObject(parent), friends_(friends)
{
    connect(&friends_, &DocumentFriends::changed, this, &ShownFriends::changed);
}

void ShownFriends::showLines(bool shown)
{
    if (linesAreShown_ == shown)
        return;
    linesAreShown_ = shown;
    linesAt_ = -1;
    Q_EMIT changed();
}

void ShownFriends::choose(std::optional<size_t> number)
{
    if (number == chosen())
        return;
    name_ = number ? std::optional(nameOf(*number)) : std::nullopt;
    number_ = number;
    linesAt_ = -1;
    Q_EMIT changed();
}

std::optional<size_t> ShownFriends::chosen()
{
    if (name_)
        find();
    return number_;
}

ShownFriends::Name ShownFriends::nameOf(size_t number) const
{
    const SceneFriends& now = friends_.friends();
    const bool naked = number >= now.edges().size();
    const EdgePart& a = naked ? now.nakedEdges()[number - now.edges().size()] : now.edges()[number].a;
    Name name{now.objects()[a.surface], a.side, {}, (a.from + a.to) / 2};
    if (!naked) {
        const EdgePart& b = now.edges()[number].b;
        name.b = {now.objects()[b.surface], b.side};
    }
    return name;
}

// The edge of that name now: of several parts the nearest one.
void ShownFriends::find()
{
    const int revision = friends_.revision();
    if (foundAt_ == revision)
        return;
    foundAt_ = revision;
    number_.reset();
    const SceneFriends& now = friends_.friends();
    double nearest = 0;
    for (size_t k = 0; k < now.edges().size() + now.nakedEdges().size(); ++k) {
        const Name name = nameOf(k);
        const double apart = std::abs(name.middle - name_->middle);
        if (name.a == name_->a && name.sideA == name_->sideA && name.b == name_->b &&
            (!number_ || apart < nearest)) {
            number_ = k;
            nearest = apart;
        }
    }
}

const std::vector<EdgeLine>& ShownFriends::lines()
{
    if (!linesAreShown_ && !name_) {
        lines_.clear();
        linesAt_ = -1;
        return lines_;
    }
    if (linesAt_ == friends_.revision())
        return lines_;
    linesAt_ = friends_.revision();
    lines_.clear();
    if (linesAreShown_)
        lines_ = friendLines(friends_.friends());
    if (const auto number = chosen()) {
        const auto wide = chosenFriendLines(friends_.friends(), *number);
        lines_.insert(lines_.end(), wide.begin(), wide.end());
    }
    return lines_;
}

}  // namespace knotspan
