#include "ui/tools/edit_checks.h"

namespace knotspan {

namespace {

// What the edit puts into a scene.
Scene contentOf(Edit edit)
{
    Scene content;
    edit.applyTo(content);
    return content;
}

}  // namespace

bool changes(const Scene& scene, const Edit& edit)
{
    const Scene content = contentOf(edit);
    for (const auto& [id, object] : content.objects())
        if (scene.find(id) != object)
            return true;
    return false;
}

Result<void> leavesLockedAlone(const Scene& scene, const Edit& edit)
{
    const Scene content = contentOf(edit);
    for (const auto& [id, object] : content.objects())
        if (const SharedObject now = scene.find(id); now && now->locked && now != object)
            return failure("\"" + now->name + "\" is locked and would have to follow",
                           "Unlock it, or switch Keep friends off");
    return {};
}

}  // namespace knotspan
