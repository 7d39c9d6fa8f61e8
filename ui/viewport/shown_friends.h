// What a window shows of the document's friends: lines over the model, and one edge that the user chose,
// which stays the same one while the model changes.
#pragma once

#include <optional>

#include "model/document/document_friends.h"
#include "renderer/frame.h"

namespace knotspan {

class ShownFriends : public QObject {
    Q_OBJECT

public:
    // The friends outlive it.
    explicit ShownFriends(DocumentFriends& friends, QObject* parent = nullptr);

    [[nodiscard]] DocumentFriends& friends() { return friends_; }

    [[nodiscard]] bool linesAreShown() const { return linesAreShown_; }
    void showLines(bool shown);

    // By number: edges() are counted first, then nakedEdges().
    void choose(std::optional<size_t> number);
    [[nodiscard]] std::optional<size_t> chosen();
    // Those that have the chosen edge; none where none is chosen.
    [[nodiscard]] std::vector<ObjectId> objects() const;

    // What the next picture has to show; where that is nothing, nothing is computed.
    [[nodiscard]] const std::vector<EdgeLine>& lines();

Q_SIGNALS:
    void changed();  // lines() or chosen()

private:
    // Names an edge through all changes: what it lies on, and where on the first of that. The numbers of
    // surfaces in them do not count.
    struct Name {
        struct Place {
            ObjectId object{};
            EdgePart edge;
            [[nodiscard]] bool isOnSameEdge(const Place& other) const;
        };
        Place a;
        std::optional<Place> b;  // none: a naked edge
        [[nodiscard]] bool isOnSameEdges(const Name& other) const;
        [[nodiscard]] double middle() const { return (a.edge.from + a.edge.to) / 2; }
    };
    [[nodiscard]] Name nameOf(size_t number) const;
    void find();

    DocumentFriends& friends_;
    bool linesAreShown_ = false;
    std::optional<Name> name_;
    std::optional<size_t> number_;  // of name_, at foundAt_
    int foundAt_ = -1;              // revision of the friends
    std::vector<EdgeLine> lines_;
    int linesAt_ = -1;
};

}  // namespace knotspan
