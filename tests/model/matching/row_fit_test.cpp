#include "model/matching/row_fit.h"

#include <limits>

#include <gtest/gtest.h>

namespace knotspan {
namespace {

const KnotVector kAlong = KnotVector::clampedUniform(3, 2);

std::vector<ControlPoint> straightRow()
{
    std::vector<ControlPoint> row;
    for (int k = 0; k < kAlong.controlPointCount(); ++k)
        row.push_back({Vec3(0, k, 0), 1});
    return row;
}

std::vector<RowSample> lifted(double scale)
{
    std::vector<RowSample> samples;
    for (const double v : sampleParameters(kAlong, 6))
        samples.push_back({v, Vec3(0, 0, 1), 0.5, scale});
    return samples;
}

TEST(FittedRow, MovesByWhatIsNeeded)
{
    const auto row = fittedRow(kAlong, straightRow(), lifted(2));
    ASSERT_TRUE(row);
    for (const double v : {0.0, 0.3, 0.9})
        EXPECT_NEAR(rowPoint(kAlong, *row, v).position.z, 0.5, 1e-6);
}

TEST(FittedRow, SaysThatThereIsNoneWhereScalesLeaveNoSolution)
{
    EXPECT_FALSE(fittedRow(kAlong, straightRow(), lifted(0)));
    EXPECT_FALSE(fittedRow(kAlong, straightRow(), lifted(std::numeric_limits<double>::infinity())));
}

}  // namespace
}  // namespace knotspan
