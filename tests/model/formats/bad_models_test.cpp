// Files that are JSON, or nearly, but no model: each refusal says which object and what.
#include <functional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "model/files/json_parsing.h"
#include "model/formats/format_list.h"
#include "model/samples/sample_list.h"
#include "tests/support.h"

namespace knotspan {
namespace {

using nlohmann::json;

class BadModels : public ::testing::Test {
protected:
    BadModels()
    {
        const auto written = formats::write(findSample("nine-16")->make(), path_);
        good_ = written ? testing::readFile(path_) : written.error().sentence();
    }

    // What reading `text` says, without the file's name; empty where it is read.
    [[nodiscard]] std::string refusal(const std::string& text) const
    {
        testing::writeFile(path_, text);
        const auto result = formats::read(path_);
        if (result)
            return "";
        const std::string start = path_.string() + ": ";
        const std::string sentence = result.error().sentence();
        return sentence.rfind(start, 0) == 0 ? sentence.substr(start.size()) : "no name: " + sentence;
    }

    // The same of a good file that `change` has spoilt.
    [[nodiscard]] std::string refusalOf(const std::function<void(json&)>& change) const
    {
        json model = json::parse(good_);
        change(model);
        return refusal(model.dump());
    }

    // And with a stretch of its text replaced.
    [[nodiscard]] std::string refusalReplacing(const std::string& old, const std::string& replacement) const
    {
        std::string text = good_;
        const size_t at = text.find(old);
        EXPECT_NE(at, std::string::npos);
        return refusal(text.replace(at, old.size(), replacement));
    }

    testing::TemporaryFolder folder_;
    std::filesystem::path path_ = folder_ / "model.knotspan";
    std::string good_;
};

TEST_F(BadModels, AreNotTheGoodOne)
{
    EXPECT_EQ(refusal(good_), "");
}

TEST_F(BadModels, OfAnotherKindOrVersionAreRefused)
{
    const std::string other =
        "This is no Knotspan model: \"format\": \"knotspan\" is missing. Choose a file that "
        "Knotspan has written.";
    EXPECT_EQ(refusal("{}"), other);
    EXPECT_EQ(refusal("[1, 2]"), other);
    EXPECT_EQ(refusal("null"), other);
    EXPECT_EQ(refusalOf([](json& m) { m["format"] = 3; }), other);
    EXPECT_EQ(refusalOf([](json& m) { m["version"] = 2; }),
              "The file is of version 2, but this Knotspan reads version 1. Use a newer Knotspan.");
    EXPECT_EQ(refusalOf([](json& m) { m["version"] = "one"; }), "version: is not a number, but string.");
}

TEST_F(BadModels, WithNumbersThatAreNoneAreRefused)
{
    EXPECT_NE(
        refusalReplacing("[-4.5,-4.5,0.0,1.0]", "[NaN,-4.5,0.0,1.0]").find("The file is damaged at line 3"),
        std::string::npos);
    EXPECT_NE(
        refusalReplacing("[-4.5,-4.5,0.0,1.0]", "[Infinity,0,0,1]").find("The file is damaged at line 3"),
        std::string::npos);
    EXPECT_EQ(refusalReplacing("[-4.5,-4.5,0.0,1.0]", "[1e999,-4.5,0.0,1.0]"),
              "The file has a number that is too large.");
    EXPECT_EQ(refusalReplacing("[-4.5,-4.5,0.0,1.0]", "[null,-4.5,0.0,1.0]"),
              "objects[0], surface, control_points[0][0]: is not a number, but null.");
    EXPECT_EQ(refusalReplacing("[-4.5,-4.5,0.0,1.0]", "[-4.5,0.0,1.0]"),
              "objects[0], surface, control_points[0]: has 3 numbers, not 4.");
}

TEST_F(BadModels, WithKnotsOrWeightsThatAreNoneAreRefused)
{
    EXPECT_EQ(refusalOf([](json& m) { m["objects"][2]["surface"]["knots_u"][4] = -1; }),
              "objects[2], surface, knots_u: Knot 4 is smaller than the one before it.");
    EXPECT_EQ(
        refusalOf([](json& m) { m["objects"][1]["surface"]["control_points"][7][3] = 0; }),
        "objects[1], surface, control_points: Control point (1, 3) has a weight that is not above zero.");
    EXPECT_EQ(
        refusalOf([](json& m) { m["objects"][1]["surface"]["control_points"][7][3] = -2.5; }),
        "objects[1], surface, control_points: Control point (1, 3) has a weight that is not above zero.");
    EXPECT_EQ(refusalOf([](json& m) { m["objects"][8]["surface"]["degree_v"] = 16; }),
              "objects[8], surface, degree_v: is no whole number from 1 to 15.");
    EXPECT_EQ(refusalOf([](json& m) { m["objects"][8]["surface"]["degree_v"] = 2.5; }),
              "objects[8], surface, degree_v: is no whole number from 1 to 15.");
    EXPECT_EQ(
        refusalOf([](json& m) { m["objects"][0]["surface"]["control_points"].erase(3); }),
        "objects[0], surface, control_points: The knots ask for 4 x 4 = 16 control points, but there are "
        "15.");
}

TEST_F(BadModels, ThatClaimTenGigabytesOfControlPointsAreRefusedWithoutMakingThem)
{
    // 20,000 x 20,000 control points of 32 bytes by their knots; there are 16.
    const std::string sentence = refusalOf([](json& m) {
        std::vector<double> knots(20'004);
        for (size_t i = 0; i < knots.size(); ++i)
            knots[i] = static_cast<double>(i);
        m["objects"][0]["surface"]["knots_u"] = knots;
        m["objects"][0]["surface"]["knots_v"] = knots;
    });
    EXPECT_EQ(sentence,
              "objects[0], surface, control_points: The knots ask for 20000 x 20000 = 400000000 control "
              "points, but there are 16.");
}

std::string missing(const char* key)
{
    std::string sentence = "\"";
    sentence.append(key).append("\" is missing.");
    return sentence;
}

TEST_F(BadModels, WithAMissingMemberAreRefused)
{
    for (const char* key : {"version", "units", "objects"})
        EXPECT_EQ(refusalOf([&](json& m) { m.erase(key); }), missing(key));
    for (const char* key : {"name", "colour", "transform", "visible", "surface", "trim_loops"})
        EXPECT_EQ(refusalOf([&](json& m) { m["objects"][4].erase(key); }), "objects[4]: " + missing(key));
    for (const char* key : {"degree_u", "degree_v", "knots_u", "knots_v", "control_points"})
        EXPECT_EQ(refusalOf([&](json& m) { m["objects"][4]["surface"].erase(key); }),
                  "objects[4], surface: " + missing(key));
}

TEST_F(BadModels, WithMembersOfTheWrongTypeAreRefused)
{
    // Whatever stands where something else should: a sentence, never a crash.
    const json values[] = {nullptr, true, -1, "text", json::array(), json::object(), json::array({1, 2, 3})};
    const json model = json::parse(good_);
    for (const char* const place : {"", "/objects/0", "/objects/0/surface"})
        for (const auto& member : model[json::json_pointer(place)].items())
            for (const json& value : values)
                if (member.value().type() != value.type()) {
                    const json::json_pointer at = json::json_pointer(place) / member.key();
                    EXPECT_NE(refusalOf([&](json& m) { m[at] = value; }), "") << at << " " << value;
                }
}

TEST_F(BadModels, WithAMemberThatStandsTwiceAreRefused)
{
    EXPECT_EQ(refusalReplacing("\"visible\":true", "\"visible\":true,\"visible\":false"),
              "\"visible\" stands twice in one place.");
    EXPECT_EQ(refusalReplacing("\"degree_u\":3", "\"degree_u\":3,\"degree_u\":3"),
              "\"degree_u\" stands twice in one place.");
}

TEST_F(BadModels, NestedAMillionDeepAreRefusedWithoutExhaustingTheStack)
{
    for (const char* opening : {"[", "{\"a\":"}) {
        std::string text;
        for (int i = 0; i < 1'000'000; ++i)
            text += opening;
        EXPECT_EQ(refusal(text),
                  "Values are nested more than 16 deep. Choose another file: this is no Knotspan "
                  "model.");
    }
}

TEST_F(BadModels, WithMoreValuesThanAllowedAreRefusedBeforeTheyTakeMemory)
{
    std::string text = "[";
    for (int i = 0; i < 2000; ++i)
        text += "0,";
    text += "0]";
    EXPECT_TRUE(formats::parsedJson(text, 2003));
    const auto refused = formats::parsedJson(text, 1000);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().sentence(),
              "The file holds more than 1000 values. Split the model into several files.");
}

TEST_F(BadModels, WithAColourOrTransformThatIsNoneAreRefused)
{
    EXPECT_EQ(refusalOf([](json& m) { m["objects"][0]["colour"][1] = 1.5; }),
              "objects[0], colour: has a part outside 0 to 1.");
    EXPECT_EQ(refusalOf([](json& m) { m["objects"][0]["transform"][15] = 2; }),
              "objects[0], transform: does not end with the row 0, 0, 0, 1.");
    EXPECT_EQ(refusalOf([](json& m) { m["objects"][0]["transform"][0] = 0; }),
              "objects[0], transform: flattens the object: it cannot be undone.");
}

TEST_F(BadModels, WithATrimLoopThatIsNoneAreRefused)
{
    const auto loop = [](json curve) {
        return json::array({{{"outer", true}, {"curves", json::array({std::move(curve)})}}});
    };
    const json good{{"degree", 1}, {"knots", {0, 0, 1, 1}}, {"control_points", {{0, 0, 1}, {1, 1, 1}}}};
    EXPECT_EQ(refusalOf([&](json& m) { m["objects"][0]["trim_loops"] = loop(good); }), "");
    json bad = good;
    bad["control_points"][1][2] = 0;
    EXPECT_EQ(
        refusalOf([&](json& m) { m["objects"][0]["trim_loops"] = loop(bad); }),
        "objects[0], trim_loops[0], curves[0], control_points: Control point 1 has a weight that is not "
        "above zero.");
    bad = good;
    bad.erase("degree");
    EXPECT_EQ(refusalOf([&](json& m) { m["objects"][0]["trim_loops"] = loop(bad); }),
              "objects[0], trim_loops[0], curves[0]: \"degree\" is missing.");
}

}  // namespace
}  // namespace knotspan
