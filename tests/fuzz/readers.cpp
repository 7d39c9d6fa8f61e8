#include "tests/fuzz/readers.h"

#include <algorithm>
#include <sstream>

#include "model/core/check.h"
#include "model/formats/bpt_format.h"
#include "model/formats/knotspan_json.h"
#include "model/formats/obj_format.h"

namespace knotspan::fuzz {

namespace {

// Names and the direction of loops without an area may differ.
bool sameSurfaces(const Scene& a, const Scene& b)
{
    return std::equal(a.objects().begin(), a.objects().end(), b.objects().begin(), b.objects().end(),
                      [](const auto& first, const auto& second) {
                          return first.second->surface == second.second->surface &&
                                 first.second->trimLoops.size() == second.second->trimLoops.size();
                      });
}

void expectToOutlastObj(const Scene& scene)
{
    std::ostringstream out;
    check(formats::writeObj(scene, out).has_value(), "a scene that was read can be written");
    const auto again = formats::sceneFromObj(out.str());
    check(again.has_value() && sameSurfaces(scene, again->scene), "OBJ files keep surfaces");
}

std::string sentenceOf(const Result<formats::Import>& import)
{
    if (!import)
        return import.error().sentence();
    expectToOutlastObj(import->scene);
    return {};
}

}  // namespace

std::string readObj(std::string_view text)
{
    return sentenceOf(formats::sceneFromObj(text));
}

std::string readBpt(std::string_view text)
{
    return sentenceOf(formats::sceneFromBpt(text));
}

std::string readKnotspan(std::string_view text)
{
    const auto json = formats::parsedJson(std::string(text));
    if (!json)
        return json.error().sentence();
    const auto scene = formats::sceneFromJson(*json);
    if (!scene)
        return scene.error().sentence();
    for (const auto& [id, object] : scene->objects()) {
        const auto again = formats::parsedJson(
            R"({"format":"knotspan","version":1,"units":"mm","objects":[)" + formats::textOf(*object) + "]}");
        check(again.has_value(), "what is written can be parsed");
        const auto back = formats::sceneFromJson(*again);
        check(back.has_value() && back->objects().begin()->second->surface == object->surface &&
                  back->objects().begin()->second->trimLoops == object->trimLoops,
              "files keep surfaces");
    }
    return {};
}

}  // namespace knotspan::fuzz
