// Damaged and random files of the formats that we read ourselves: a model or a sentence each, never a crash.
// The fuzz targets (tests/fuzz) search for such files as long as one likes.
#include <random>

#include <gtest/gtest.h>

#include "model/formats/knotspan_json.h"
#include "obj_text.h"
#include "tests/fuzz/readers.h"
#include "tests/model/formats/hostile_files.h"

namespace knotspan {
namespace {

using testing::polygon;
using testing::sixPointSurface;
using testing::sixVertices;

std::string objText()
{
    return sixVertices() + "vt 0 0\no name # x\n" + polygon("0.25 0.25  0.75 0.25  0.75 0.75  0.25 0.25") +
           "vp 0 0 1\nvp .5 .1 2\nvp 1 0 3\ncstype rat bezier\ndeg 2\ncurv2 -3 -2 -1\nparm u 0 1\nend\n" +
           sixPointSurface("trim 0 1.5 1 1.5 3 1\nhole 1 0 2 0 1 2\nsp 1\n") +
           "cstype rat bezier\ndeg 1 1\nsurf .25 2 0 1 1/1 2/1 3 \\\n4 5 6 # six\nparm u 0 1 2\nparm v 0 "
           "1\nend\nf 1 2 3\n";
}

std::string knotspanText()
{
    const Scene scene = testing::sceneOf(objText());
    std::string text = R"({"format": "knotspan", "version": 1, "units": "mm", "objects": [)";
    const char* separator = "\n";
    for (const auto& [id, object] : scene.objects()) {
        text += separator + formats::textOf(*object);
        separator = ",\n";
    }
    return text + "\n]}\n";
}

// The loops of its surface alone: the text that is before and behind them is in fuzz::readTrimLoops().
std::string loopsText()
{
    return R"([{"outer": true, "curves": [{"degree": 1, "knots": [0, 0, 1, 2, 2], )"
           R"("control_points": [[0, 0, 1], [1, 0, 1], [0.5, 1, 1]]}, {"degree": 2, "knots": [0, 0, 0, 1, 1, 1], )"
           R"("control_points": [[0.5, 1, 1], [0, 1, 0.5], [0, 0, 1]]}]}])";
}

struct Reader {
    const char* name;
    std::string whole;
    std::string (*read)(std::string_view);
    std::vector<std::string> words;  // that mean something to it
};

const std::vector<Reader>& readers()
{
    static const std::vector<Reader> list{
        {"obj",
         objText(),
         fuzz::readObj,
         {"surf 0 1 0 1 ", "end\n", "\\\n", "parm u ", "trim ", "hole ", "curv2 ", "cstype rat bspline\n",
          "deg 3 3\n", "1e308 ", "-1 ", "0 ", "nan ", "1e-320 ", "#", "v 1 1 1 1e-300\n", "99999999 "}},
        {"bpt",
         testing::handWrittenFile("bpt"),
         fuzz::readBpt,
         {"15 15\n", "1000000\n", "1e308 ", "nan ", "-1 ", "\n", "0 "}},
        {"knotspan",
         knotspanText(),
         fuzz::readKnotspan,
         {"[", "]", "{", "}", "null", "1e308", "-1", "0", "\"surface\": ", "[[[[[[[[[[[[[[[[[[", ","}},
        {"trim loops",
         loopsText(),
         fuzz::readTrimLoops,
         {"[", "]", "{", "}", "null", "1e308", "-1e308", "-1", "0", "1e-320", ",", "2.5",
          "\"degree\": 15, "}},
        {"stl",
         testing::handWrittenFile("stl"),
         fuzz::readStl,
         {"vertex 1 1 1\n", "endloop\n", "1e39 ", "nan ", "solid\n", "facet ", "normal ", "\n"}},
        {"ply",
         testing::handWrittenFile("ply"),
         fuzz::readPly,
         {"element face 9\n", "property list uchar int vertex_indices\n", "property double x\n", "comment\n",
          "binary_little_endian", "binary_big_endian", "4000000000 ", "-1 ", "nan ", "\n", "0 "}},
        {"off",
         testing::handWrittenFile("off"),
         fuzz::readOff,
         {"ST", "4000000000 ", "-1 ", "nan ", "#", "\n", "3 0 1 2\n", "1e308 "}},
        {"gltf",
         testing::handWrittenFile("gltf"),
         fuzz::readGltf,
         {"[", "]", "{", "}", "null", "1e308", "-1", "0", "4000000000", ",", "\"byteOffset\": 4, ",
          "\"byteStride\": 4, ", "\"indices\": 0, ", "\"mode\": 5, ", "\"children\": [0], ", "5121", "=",
          "AAAA"}},
    };
    return list;
}

TEST(HostileFiles, StartFromTextsThatAreModels)
{
    for (const Reader& reader : readers())
        EXPECT_EQ(reader.read(reader.whole), "") << reader.name;
}

TEST(HostileFiles, CutOffAnywhereAreModelsOrRefused)
{
    for (const Reader& reader : readers())
        for (size_t part = 0; part < 64; ++part) {
            const std::string_view text =
                std::string_view(reader.whole).substr(0, reader.whole.size() * part / 64);
            const std::string sentence = reader.read(text);
            // OBJ files do not say how long they are, text STL files may end after each triangle, and any text
            // without its last line end.
            if (reader.name != std::string("obj") && reader.name != std::string("stl") &&
                text.size() + 1 < reader.whole.size()) {
                EXPECT_NE(sentence, "") << reader.name << " " << part;
            }
        }
}

TEST(HostileFiles, OfRandomBytesAreRefused)
{
    std::mt19937 random(7);
    for (const Reader& reader : readers()) {
        for (int k = 0; k < 50; ++k) {
            std::string noise;
            for (unsigned n = 16 + random() % 4000; n > 0; --n)
                noise += static_cast<char>(random() % 255 + 1);
            EXPECT_NE(reader.read(noise), "") << reader.name;
        }
    }
}

TEST(HostileFiles, WithAThousandSingleBytesChangedAreModelsOrRefused)
{
    std::mt19937 random(8);
    for (const Reader& reader : readers()) {
        int refused = 0;
        for (int k = 0; k < 1000; ++k) {
            std::string text = reader.whole;
            text[random() % text.size()] = static_cast<char>(random() % 256);
            const std::string sentence = reader.read(text);
            refused += sentence.empty() ? 0 : 1;
            EXPECT_TRUE(sentence.empty() || sentence.back() == '.') << sentence;
        }
        EXPECT_GT(refused, 100) << reader.name;
        EXPECT_LT(refused, 1000) << reader.name;
    }
}

// Words put in, parts doubled, taken out and exchanged: what libFuzzer does, but the same each time.
std::string changed(const Reader& reader, std::mt19937& random)
{
    std::string text = reader.whole;
    for (unsigned n = 1 + random() % 6; n > 0 && !text.empty(); --n) {
        const size_t at = random() % text.size();
        const size_t length = random() % std::min<size_t>(40, text.size() - at) + 1;
        switch (random() % 5) {
        case 0:
            text.insert(at, reader.words[random() % reader.words.size()]);
            break;
        case 1:
            text.replace(at, length, reader.words[random() % reader.words.size()]);
            break;
        case 2:
            text.erase(at, length);
            break;
        case 3:
            text.insert(random() % text.size(), text.substr(at, length));
            break;
        default:
            text[at] = static_cast<char>("0123456789.-e \n"[random() % 15]);
        }
    }
    return text;
}

TEST(HostileFiles, ChangedAtRandomAreModelsOrRefused)
{
    std::mt19937 random(9);
    for (const Reader& reader : readers()) {
        int models = 0;
        for (int k = 0; k < 4000; ++k)
            models += reader.read(changed(reader, random)).empty() ? 1 : 0;
        EXPECT_GT(models, 20) << reader.name;
        EXPECT_LT(models, 3900) << reader.name;
    }
}

}  // namespace
}  // namespace knotspan
