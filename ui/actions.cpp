#include "ui/actions.h"

#include <QCoreApplication>

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

const std::vector<MouseInfo>& mouseList()
{
    static const std::vector<MouseInfo> kList = {
        {TEXT("Left click"), TEXT("Select what lights up under the cursor; on nothing: deselect")},
        {TEXT("Shift + click, Ctrl + click"),
         TEXT("Add an object or a control point to the selection; take it in or out")},
        {TEXT("Left drag on a control point"), TEXT("Move it, or all selected ones, as the panel Tool "
                                                    "settings says; with Shift held by a tenth; Escape "
                                                    "takes it back")},
        {TEXT("Left drag on a handle"), TEXT("Move, turn or scale what is selected that way")},
        {TEXT("X, Y, Z, U, V, N during a drag"), TEXT("Keep to that axis; once more: go freely again")},
        {TEXT("Digits during a drag"),
         TEXT("Type how far, or after = to where; Enter takes it, Backspace goes back")},
        {TEXT("Left drag elsewhere, middle drag, Alt + left drag"),
         TEXT("Orbit; boxes and lassos leave it to the last two")},
        {TEXT("Right drag, Shift + middle drag"), TEXT("Pan")},
        {TEXT("Wheel, Ctrl + middle drag"), TEXT("Zoom at the cursor")},
        {TEXT("Drop files"), TEXT("Open the first, add the others")},
    };
    return kList;
}

#undef TEXT

}  // namespace knotspan
