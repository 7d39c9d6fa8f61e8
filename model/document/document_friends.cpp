#include "model/document/document_friends.h"

namespace knotspan {

DocumentFriends::DocumentFriends(Document& document, QObject* parent) : QObject(parent), document_(document)
{
    connect(&document_, &Document::documentReplaced, this,
            [this] { setTolerances(defaultTolerances(document_.isImported())); });
    connect(&document_, &Document::sceneChanged, this, &DocumentFriends::growStale);
}

const SceneFriends& DocumentFriends::friends()
{
    if (stale_) {
        stale_ = false;
        if (friends_.follow(document_.scene()))
            ++revision_;
    }
    return friends_;
}

int DocumentFriends::revision()
{
    (void)friends();
    return revision_;
}

void DocumentFriends::setTolerances(const FriendTolerances& tolerances)
{
    if (tolerances == friends_.tolerances())
        return;
    friends_.setTolerances(tolerances);
    growStale();
}

void DocumentFriends::growStale()
{
    stale_ = true;
    Q_EMIT changed();
}

}  // namespace knotspan
