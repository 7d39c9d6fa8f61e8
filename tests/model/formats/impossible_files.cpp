#include <cstdint>

#include "tests/model/formats/hostile_files.h"

namespace knotspan::testing {

namespace {

std::string repeated(const std::string& text, int count)
{
    std::string all;
    for (int k = 0; k < count; ++k)
        all += text;
    return all;
}

std::string stepFile(const std::string& data)
{
    return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
           "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n" +
           data + "ENDSEC;\nEND-ISO-10303-21;\n";
}

std::string millionPointStep()
{
    const std::string row = "(#1" + repeated(",#1", 999) + ")";
    return stepFile("#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=B_SPLINE_SURFACE_WITH_KNOTS('',3,3,(" + row +
                    repeated("," + row, 999) +
                    "),.UNSPECIFIED.,.F.,.F.,.F.,(4,4),(4,4),(0.,1.),(0.,1.),.UNSPECIFIED.);\n");
}

// Lines of 72 columns, a letter and a number.
std::string igesFile(const std::vector<std::string>& parameters, const std::string& entity)
{
    const auto line = [](std::string text, char section, size_t number) {
        text.resize(72, ' ');
        std::string count = std::to_string(number);
        count.insert(0, 7 - count.size(), ' ');
        return text + section + count + "\n";
    };
    const auto field = [](const std::string& text) { return std::string(8 - text.size(), ' ') + text; };
    const std::string count = std::to_string(parameters.size());
    std::string text =
        line("", 'S', 1) +
        line("1H,,1H;,4Htest,4Htest,4Htest,4Htest,32,38,6,308,15,4Htest,1.,2,2HMM,1,", 'G', 1) +
        line("1.,15H20200101.000000,1E-6,1.,4Htest,4Htest,11,0,15H20200101.000000;", 'G', 2);
    text += line(field(entity) + field("1") + repeated(field("0"), 7), 'D', 1) +
            line(field(entity) + field("0") + field("0") + field(count) + field("0"), 'D', 2);
    for (size_t k = 0; k < parameters.size(); ++k) {
        std::string data = parameters[k];
        data.resize(64, ' ');
        text += line(data + field("1"), 'P', k + 1);
    }
    return text + line("S      1G      2D      2P" + field(count).substr(1), 'T', 1);
}

std::string glb(const std::string& json)
{
    const auto number = [](std::uint32_t value) {
        std::string bytes;
        for (int k = 0; k < 4; ++k)
            bytes += static_cast<char>(value >> (8 * k) & 255U);
        return bytes;
    };
    const auto size = static_cast<std::uint32_t>(json.size());
    return "glTF" + number(2) + number(20 + size) + number(size) + "JSON" + json;
}

// Of a mesh with a node, some members another way.
std::string gltfWith(const std::string& old, const std::string& replacement)
{
    std::string text = handWrittenFile("gltf");
    return text.replace(text.find(old), old.size(), replacement);
}

std::string vtpWith(const std::string& points, const std::string& body)
{
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\"><PolyData><Piece NumberOfPoints=\"" +
           points + "\" NumberOfPolys=\"" + points + "\">" + body + "</Piece></PolyData></VTKFile>\n";
}

std::vector<HostileFile> impossibleGltf()
{
    std::vector<std::string> texts{
        gltfWith("\"count\": 3", "\"count\": 4000000000"),
        gltfWith("\"count\": 3", "\"count\": 18446744073709551615"),
        gltfWith("\"byteLength\": 36}", "\"byteLength\": 1000000000000}"),
        gltfWith("\"children\": [1]", "\"children\": [0, 0]"),
        gltfWith("{\"mesh\": 0, ", "{\"children\": [0, 1], "),
        gltfWith("\"uri\": \"data:", "\"uri\": \"/dev/zero\", \"x\": \""),
        gltfWith("\"uri\": \"data:", "\"uri\": \"../../../../etc/passwd\", \"x\": \""),
        repeated("[", 100'000),
        repeated("{\"a\":", 100'000),
    };
    std::vector<HostileFile> files;
    for (const std::string& text : texts) {
        files.push_back({text.substr(0, 60), "gltf", text});
        files.push_back({text.substr(0, 60), "glb", glb(text)});
    }
    return files;
}

}  // namespace

std::vector<HostileFile> impossibleFilesOf(const std::string& extension)
{
    const auto named = [&](const std::vector<std::string>& texts) {
        std::vector<HostileFile> files;
        for (const std::string& text : texts)
            files.push_back({text.substr(0, 60), extension, text});
        return files;
    };
    if (extension == "step")
        return named({millionPointStep(),
                      stepFile("#1=CARTESIAN_POINT(''," + repeated("(", 100'000) + "0." +
                               repeated(")", 100'000) + ");\n"),
                      stepFile("#1=CARTESIAN_POINT(''," + repeated("(", 100'000)),
                      stepFile("#1=ADVANCED_FACE('',(#1),#1,.T.);\n#2=CLOSED_SHELL('',(#1,#2));\n"
                               "#3=MANIFOLD_SOLID_BREP('',#3);\n#4=MAPPED_ITEM('',#4,#4);\n")});
    if (extension == "igs")
        // A surface of a million points, a trimmed surface and a group of which each is its own part.
        return named({igesFile({"128,999,999,3,3,0,0,1,0,0,0.,0.,0.,0.,1.;"}, "128"),
                      igesFile({"128,2000000000,2000000000,3,3,0,0,1,0,0;"}, "128"),
                      igesFile({"126,2000000000,3,0,0,1,0,0.,0.,1.,1.;"}, "126"),
                      igesFile({"144,1,0,0,1;"}, "144"), igesFile({"402,3,1,1,1;"}, "402"),
                      igesFile({"102,2,1,1;"}, "102"), igesFile({"402,2000000000,1;"}, "402")});
    if (extension == "brep")
        return named({"DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nLocations "
                      "2000000000\n",
                      "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nLocations "
                      "0\nCurve2ds 0\nCurves 0\nPolygon3D 0\nPolygonOnTriangulations 0\nSurfaces 1\n9 0 0 0 "
                      "0 3 3 2000000000 2000000000 2 2 \n",
                      "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nLocations "
                      "0\nCurve2ds 0\nCurves 0\nPolygon3D 0\nPolygonOnTriangulations 0\nSurfaces "
                      "0\nTriangulations 1\n2000000000 2000000000 0 0\n"});
    if (extension == "knotspan")
        return named(
            {repeated("[", 1'000'000), repeated("{\"a\":", 1'000'000),
             R"({"format": "knotspan", "version": 1, "units": "mm", "objects": [)" + repeated("[", 100'000)});
    if (extension == "obj")
        return named({"v 0 0 0\ncstype bspline\ndeg 3 3\nsurf 0 1 0 1 1\nparm u" +
                          repeated(" 0.5", 1'000'000) + "\nparm v" + repeated(" 0.5", 1000) + "\nend\n",
                      "v 0 0 0\ncstype bspline\ndeg 1000000000 1000000000\nsurf 0 1 0 1 1\nend\n",
                      "v 0 0 0\nf 1 2000000000 -2000000000\n", "v 0 0 0\ncall " + repeated("a", 1'000'000)});
    if (extension == "bpt")
        return named({"1000000\n", "1\n1000 1000\n0 0 0\n", "2000000000\n15 15\n", "-1\n3 3\n"});
    if (extension == "stl")
        return named({std::string(80, ' ') + "\xff\xff\xff\xff",
                      std::string(80, 'x') + "\x40\x42\x0f" + std::string(1, '\0'),
                      "solid " + repeated("facet\n", 100'000)});
    if (extension == "ply")
        return named(
            {"ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float "
             "y\nproperty float z\nend_header\n",
             "ply\nformat binary_little_endian 1.0\nelement vertex 18446744073709551615\nproperty float "
             "x\nproperty float y\nproperty float z\nend_header\n0",
             "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uint int "
             "vertex_indices\nend_header\n\xff\xff\xff\xff",
             "ply\nformat ascii 1.0\nelement nothing 4000000000\nelement vertex 4000000000\nend_header\n",
             "ply\n" + repeated("comment\n", 100'000)});
    if (extension == "off")
        return named(
            {"OFF\n2000000000 2000000000 0\n", "OFF\n1 1 0\n0 0 0\n2000000000 0\n", "OFF\n0 2000000000 0\n"});
    if (extension == "vtp")
        return named({vtpWith("4000000000", ""), vtpWith("-1", ""), vtpWith("3", repeated("<a>", 100'000)),
                      vtpWith("1000000", "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
                                         "format=\"ascii\">0 0 0</DataArray></Points>"),
                      "<?xml version=\"1.0\"?><!DOCTYPE x [<!ENTITY a \"" + repeated("a", 100) +
                          "\"><!ENTITY b \"" + repeated("&a;", 100) + "\"><!ENTITY c \"" +
                          repeated("&b;", 100) + "\"><!ENTITY d \"" + repeated("&c;", 100) +
                          "\">]><VTKFile type=\"PolyData\" version=\"1.0\">&d;</VTKFile>"});
    if (extension == "glb")
        return impossibleGltf();
    return {};
}

}  // namespace knotspan::testing
