#include "ui/tools/typed_numbers.h"

#include <gtest/gtest.h>

namespace knotspan {
namespace {

TypedNumbers typed(const std::string& text)
{
    TypedNumbers numbers;
    for (const char sign : text)
        EXPECT_TRUE(numbers.type(sign)) << sign;
    return numbers;
}

using Values = std::vector<double>;

TEST(TypedNumbers, AreOneToThreePartedBySpacesOrCommas)
{
    EXPECT_EQ(typed("2.5").numbers()->values, Values{2.5});
    EXPECT_EQ(typed("-.5").numbers()->values, Values{-0.5});
    EXPECT_EQ(typed("1 0 -3").numbers()->values, (Values{1, 0, -3}));
    EXPECT_EQ(typed(" 1, 2.25 ").numbers()->values, (Values{1, 2.25}));
    EXPECT_EQ(typed("0.1").numbers()->values, Values{0.1});  // the same double that the compiler reads
    EXPECT_FALSE(typed("1").numbers()->absolute);
    EXPECT_TRUE(typed("=1").numbers()->absolute);
    EXPECT_EQ(typed("= 4 5").numbers()->values, (Values{4, 5}));
}

TEST(TypedNumbers, RefuseWhatIsNoNumberWithASentence)
{
    for (const char* text : {"-", ".", "=", "1-", "1=2", "--2", "1.2.3", "1 2 3 4", "  ", "1 -"}) {
        const auto numbers = typed(text).numbers();
        ASSERT_FALSE(numbers.has_value()) << text;
        EXPECT_FALSE(numbers.error().sentence().empty());
    }
    EXPECT_TRUE(typed(std::string(12, '9')).numbers());
    EXPECT_FALSE(typed(std::string(80, '9')).numbers()) << "pictures of it would be noise";
    TypedNumbers numbers;
    EXPECT_FALSE(numbers.type('a'));
    EXPECT_FALSE(numbers.type('\0'));
    EXPECT_TRUE(numbers.isEmpty());
}

TEST(TypedNumbers, BackspaceTakesTheLastSign)
{
    TypedNumbers numbers = typed("12");
    EXPECT_TRUE(numbers.erase());
    EXPECT_EQ(numbers.text(), "1");
    EXPECT_TRUE(numbers.erase());
    EXPECT_FALSE(numbers.erase());
}

TEST(TypedNumbers, AreMovementsOrPlaces)
{
    const Vec3 start(10, 20, 30);
    EXPECT_EQ(movementBy(*typed("1 2").numbers(), start).value(), Vec3(1, 2, 0));
    EXPECT_EQ(movementBy(*typed("=1 2").numbers(), start).value(), Vec3(-9, -18, 0));
    EXPECT_EQ(distanceBy(*typed("4").numbers(), DragAxis::normal, start).value(), 4);
    EXPECT_EQ(distanceBy(*typed("=4").numbers(), DragAxis::y, start).value(), -16);
    EXPECT_FALSE(distanceBy(*typed("=4").numbers(), DragAxis::normal, start).has_value());
    EXPECT_FALSE(distanceBy(*typed("=4").numbers(), DragAxis::u, start).has_value());
    EXPECT_FALSE(distanceBy(*typed("4 5").numbers(), DragAxis::x, start).has_value());
    EXPECT_EQ(singleOf(*typed("30").numbers()).value(), 30);
    EXPECT_FALSE(singleOf(*typed("=30").numbers()).has_value());
    EXPECT_FALSE(singleOf(*typed("1 2").numbers()).has_value());
}

}  // namespace
}  // namespace knotspan
