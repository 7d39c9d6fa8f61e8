// The friends of the document's scene, found when somebody asks and then kept up to date with it. Whoever
// shows them listens to changed() and asks again; where nobody asks, nothing is computed, and however many
// ask after one change, it is computed once.
#pragma once

#include "model/document/document.h"
#include "model/friends/scene_friends.h"

namespace knotspan {

class DocumentFriends : public QObject {
    Q_OBJECT

public:
    // The document outlives it.
    explicit DocumentFriends(Document& document, QObject* parent = nullptr);

    // Of the visible objects, as the scene is now. Valid until the scene or the tolerances change.
    [[nodiscard]] const SceneFriends& friends();
    // Another number whenever friends() says something else than before.
    [[nodiscard]] int revision();
    // Whether friends() would have to compute something.
    [[nodiscard]] bool isStale() const { return stale_; }

    [[nodiscard]] const FriendTolerances& tolerances() const { return friends_.tolerances(); }
    void setTolerances(const FriendTolerances& tolerances);  // until another model is opened

Q_SIGNALS:
    void changed();  // friends() may say something else than before

private:
    void growStale();

    Document& document_;
    SceneFriends friends_;
    bool stale_ = true;
    int revision_ = 0;
};

}  // namespace knotspan
