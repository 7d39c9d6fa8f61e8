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
    if (number == chosen() && number.has_value() == name_.has_value())
        return;  // what is chosen may not be found just now
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

std::vector<ObjectId> ShownFriends::objects() const
{
    std::vector<ObjectId> having;
    if (name_)
        having.push_back(name_->a.object);
    if (name_ && name_->b)
        having.push_back(name_->b->object);
    return having;
}

ShownFriends::Name ShownFriends::nameOf(size_t number) const
{
    const SceneFriends& now = friends_.friends();
    const bool naked = number >= now.edges().size();
    const EdgePart& a = naked ? now.nakedEdges()[number - now.edges().size()] : now.edges()[number].a;
    const auto place = [&now](const EdgePart& edge) {
        return Name::Place{now.objects()[edge.surface], edge};
    };
    Name name{place(a), {}};
    if (!naked)
        name.b = place(now.edges()[number].b);
    return name;
}

bool ShownFriends::Name::Place::isOnSameEdge(const Place& other) const
{
    EdgePart same = edge;
    same.surface = other.edge.surface;
    return object == other.object && same.isOnSameEdge(other.edge);
}

bool ShownFriends::Name::isOnSameEdges(const Name& other) const
{
    return a.isOnSameEdge(other.a) && b.has_value() == other.b.has_value() &&
           (!b || b->isOnSameEdge(*other.b));
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
        const double apart = std::abs(name.middle() - name_->middle());
        if (name.isOnSameEdges(*name_) && (!number_ || apart < nearest)) {
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
