// Meshes of the corpora's closed shells, all of them: `./test --corpus -L corpus`. KNOTSPAN_CORPUS_JOBS and
// KNOTSPAN_CORPUS_SHARE as in corpora_test.cpp.
#include <iostream>

#include <gtest/gtest.h>

#include "tests/corpus/solid_meshes.h"
#include "tests/support.h"

namespace knotspan::corpus {
namespace {

TEST(SolidMeshes, OfClosedShellsAreClosedAndWithinTheDeviation)
{
    const testing::TemporaryFolder scratch;
    std::vector<SolidMeshes> all;
    size_t shells = 0;
    size_t closed = 0;
    for (const Corpus& corpus : corpora(scratch.path())) {
        // Tens of thousands of parts of one maker's program; the others are of many.
        if (corpus.files.empty() || corpus.name == "kicad-packages3d")
            continue;
        all.push_back(solidMeshesOf(corpus.files, scratch.path()));
        shells += all.back().shells;
        closed += all.back().closed;
        EXPECT_EQ(all.back().within, all.back().shells) << all.back().corpus;
        EXPECT_EQ(all.back().beyondBound, 0U) << all.back().corpus;
    }
    if (all.empty())
        GTEST_SKIP() << "none of the corpora is installed: ./test --corpus installs them";
    std::cout << tableOf(all);
    EXPECT_GE(static_cast<double>(closed), 0.95 * static_cast<double>(shells));
}

}  // namespace
}  // namespace knotspan::corpus
