#include "model/matching/scene_match.h"

#include <algorithm>
#include <cmath>

#include "model/matching/neighbours.h"

namespace knotspan {

namespace {

PlacedSurface placed(const SharedObject& object)
{
    return {&object->surface, object->transform};
}

// The object with its new surface, where that is another one.
void put(Edit& edit, ObjectId id, const SharedObject& before, const std::optional<MatchedSurface>& matched)
{
    if (!matched || matched->surface == before->surface)
        return;
    auto after = std::make_shared<SceneObject>(*before);
    after->surface = matched->surface;
    edit.set(id, std::move(after));
}

double overlap(const EdgePart& x, const EdgePart& y)
{
    return std::min(x.to, y.to) - std::max(x.from, y.from);
}

}  // namespace

std::vector<ObjectEdge> edgesOf(const Scene& scene, const std::set<ObjectId>& objects,
                                const FriendTolerances& tolerances)
{
    std::set<ObjectId> there;
    for (const ObjectId id : objects)
        if (scene.find(id))
            there.insert(id);
    SceneFriends friends(tolerances);
    friends.follow(partOf(scene, neighbours(scene, there, 1, 3 * tolerances.gap)), true);
    std::vector<ObjectEdge> edges;
    for (const FriendEdge& edge : friends.edges()) {
        const ObjectId a = friends.objects()[edge.a.surface];
        const ObjectId b = friends.objects()[edge.b.surface];
        if (there.count(a) != 0 || there.count(b) != 0)
            edges.push_back({edge, a, b});
    }
    return edges;
}

std::optional<ObjectEdge> foundAgain(const Scene& scene, const ObjectEdge& edge,
                                     const FriendTolerances& tolerances)
{
    std::optional<ObjectEdge> best;
    double most = 0;
    for (const ObjectEdge& other : edgesOf(scene, {edge.a, edge.b}, tolerances)) {
        const bool isSame = other.a == edge.a && other.b == edge.b && other.edge.a.side == edge.edge.a.side &&
                            other.edge.b.side == edge.edge.b.side;
        if (isSame && overlap(other.edge.a, edge.edge.a) > most) {
            most = overlap(other.edge.a, edge.edge.a);
            best = other;
        }
    }
    return best;
}

Result<SceneMatch> matchInScene(const Scene& scene, const ObjectEdge& edge, Continuity wanted,
                                MatchSides move, const FriendTolerances& tolerances)
{
    const SharedObject a = scene.find(edge.a);
    const SharedObject b = scene.find(edge.b);
    if (!a || !b)
        return failure("The edge's objects are no longer there", "Choose another edge");
    MatchRequest request{placed(a),          placed(b), edge.edge.a, edge.edge.b,
                         edge.edge.reversed, wanted,    move,        tolerances};
    request.edgeA.surface = 0;
    request.edgeB.surface = edge.a == edge.b ? 0 : 1;
    auto proposal = matchEdge(request);
    if (!proposal)
        return tl::unexpected(proposal.error());
    SceneMatch match;
    put(match.edit, edge.a, a, proposal->a);
    put(match.edit, edge.b, b, proposal->b);
    match.proposal = *std::move(proposal);
    return match;
}

std::string describe(const Scene& scene, const ObjectEdge& edge)
{
    return std::string(sideName(edge.edge.a.side)) + " of " + nameOf(scene, edge.a) + " and " +
           sideName(edge.edge.b.side) + " of " + nameOf(scene, edge.b);
}

}  // namespace knotspan
