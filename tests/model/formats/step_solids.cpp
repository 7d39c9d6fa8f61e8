#include "tests/model/formats/step_solids.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "tests/support.h"

namespace knotspan::testing {

void writeStep(const TopoDS_Shape& shape, const std::filesystem::path& path)
{
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPControl_Writer writer;
    EXPECT_EQ(writer.Transfer(shape, STEPControl_AsIs), IFSelect_RetDone);
    EXPECT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
}

formats::Import throughStep(const TopoDS_Shape& shape)
{
    const TemporaryFolder folder;
    writeStep(shape, folder / "solid.step");
    auto import = formats::readStep(folder / "solid.step");
    EXPECT_TRUE(import.has_value()) << (import ? "" : import.error().sentence());
    return import ? std::move(*import) : formats::Import{};
}

std::vector<SampledPoint> samplesOf(const Scene& scene, int steps)
{
    std::vector<SampledPoint> samples;
    for (const auto& [id, object] : scene.objects()) {
        const KnotVector& knotsU = object->surface.knotsU();
        const KnotVector& knotsV = object->surface.knotsV();
        for (int i = 0; i <= steps; ++i) {
            for (int j = 0; j <= steps; ++j) {
                const double u =
                    knotsU.domainStart() + (knotsU.domainEnd() - knotsU.domainStart()) * i / steps;
                const double v =
                    knotsV.domainStart() + (knotsV.domainEnd() - knotsV.domainStart()) * j / steps;
                samples.push_back({evaluate(object->surface, u, v).position,
                                   evaluateNormal(object->surface, u, v).direction});
            }
        }
    }
    return samples;
}

}  // namespace knotspan::testing
