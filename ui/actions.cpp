#include "ui/actions.h"

#include <QCoreApplication>

#include "ui/viewport/navigation_presets.h"

namespace knotspan {

#define TEXT(text) QT_TRANSLATE_NOOP("knotspan::Actions", text)

const std::vector<MenuInfo>& menuList()
{
    static const std::vector<MenuInfo> kList = {{"file", TEXT("&File")},     {"edit", TEXT("&Edit")},
                                                {"tools", TEXT("&Tools")},   {"points", TEXT("&Points")},
                                                {"object", TEXT("&Object")}, {"view", TEXT("&View")},
                                                {"help", TEXT("&Help")}};
    return kList;
}

const std::vector<ActionInfo>& actionList()
{
    static const std::vector<ActionInfo> kList = [] {
        std::vector<ActionInfo> list;
        for (const auto* part : {&fileActions(), &editActions(), &toolActions(), &pointActions(),
                                 &objectActions(), &viewActions(), &helpActions()})
            list.insert(list.end(), part->begin(), part->end());
        return list;
    }();
    return kList;
}

std::string_view menuOf(const ActionInfo& action)
{
    const std::string_view id = action.id;
    return id.substr(0, id.find('.'));
}

QString translatedAction(const char* text)
{
    return QCoreApplication::translate("knotspan::Actions", text);
}

namespace {

struct MouseRow {
    const char* gesture;
    const char* meaning;
};

constexpr MouseRow kToolRows[] = {
    {TEXT("Left click"), TEXT("Select what lights up under the cursor; on nothing: deselect")},
    {TEXT("Shift + click, Ctrl + click"),
     TEXT("Add an object or a control point to the selection; take it in or out")},
    {TEXT("Left drag on a control point"),
     TEXT(
         "Move it, or all selected ones, as the panel Tool settings says; with Shift held by a tenth; Escape "
         "takes it back")},
    {TEXT("Left drag on a handle"), TEXT("Move, turn or scale what is selected that way")},
    {TEXT("X, Y, Z, U, V, N during a drag"), TEXT("Keep to that axis; once more: go freely again")},
    {TEXT("Digits during a drag"),
     TEXT("Type how far, or after = to where; Enter takes it, Backspace goes back")},
};
constexpr MouseRow kLeftOrbits = {TEXT("Left drag elsewhere"),
                                  TEXT("Orbit; boxes and lassos take these drags, too")};
constexpr MouseRow kLeftSelects = {TEXT("Left drag elsewhere"),
                                   TEXT("Select what lies in the box; Shift adds, Ctrl takes in or out")};
constexpr MouseRow kFiles = {TEXT("Drop files"), TEXT("Open the first, add the others")};

}  // namespace

std::vector<MouseInfo> mouseList(const NavigationPreset& navigation)
{
    std::vector<MouseInfo> list;
    const auto add = [&](const MouseRow& row) {
        list.push_back({translatedAction(row.gesture), translatedAction(row.meaning)});
    };
    for (const MouseRow& row : kToolRows)
        add(row);
    add(navigation.leftOrbits ? kLeftOrbits : kLeftSelects);
    list.push_back({gesturesFor(navigation, ViewTurn::orbit), translatedAction(TEXT("Orbit"))});
    list.push_back({gesturesFor(navigation, ViewTurn::pan), translatedAction(TEXT("Pan"))});
    const QString wheel = translatedAction(TEXT("Wheel"));
    const QString zoom = gesturesFor(navigation, ViewTurn::zoom);
    list.push_back({zoom.isEmpty() ? wheel : QString("%1, %2").arg(wheel, zoom),
                    translatedAction(TEXT("Zoom at the cursor; drags: up comes closer"))});
    add(kFiles);
    return list;
}

#undef TEXT

}  // namespace knotspan
