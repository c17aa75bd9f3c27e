#include "hodt/optimize/objective.h"

#include <string>

#include <gtest/gtest.h>

#include "hodt/base/error.h"

namespace hodt {
namespace {

TEST(Objective, names_lead_back) {
  for (const Objective objective :
       {Objective::none, Objective::min_local_minima, Objective::min_local_maxima,
        Objective::min_local_extrema, Objective::min_max_degree})
    EXPECT_EQ(objective_from_name(name_of(objective)), objective);
  for (const Direction d : {Direction::minimize, Direction::maximize})
    for (const Aggregate a : {Aggregate::sum, Aggregate::max, Aggregate::min})
      for (int m = 0; m < int(TriangleMeasure::own) + int(EdgeMeasure::own); ++m) {
        const Objective objective =
            m < TriangleMeasure::own ? Objective(d, a, TriangleMeasure::Kind(m))
                                     : Objective(d, a, EdgeMeasure::Kind(m - TriangleMeasure::own));
        EXPECT_EQ(objective_from_name(name_of(objective)), objective) << name_of(objective);
      }
  EXPECT_EQ(name_of({Direction::maximize, Aggregate::min, TriangleMeasure::small_angle}),
            "max-min-small-angle");
  EXPECT_EQ(method_from_name("flip"), Method::flip);
  EXPECT_EQ(method_from_name("exact"), Method::exact);
  EXPECT_EQ(method_from_name("auto"), Method::automatic);
  EXPECT_EQ(method_from_name("greedy"), Method::greedy);
}

TEST(Objective, what_counts) {
  EXPECT_TRUE(counts_minima(Objective::min_local_minima));
  EXPECT_FALSE(counts_maxima(Objective::min_local_minima));
  EXPECT_FALSE(counts_minima(Objective::min_local_maxima));
  EXPECT_TRUE(counts_maxima(Objective::min_local_maxima));
  EXPECT_TRUE(counts_minima(Objective::min_local_extrema));
  EXPECT_TRUE(counts_maxima(Objective::min_local_extrema));
  EXPECT_FALSE(counts_minima(Objective::none));
  EXPECT_FALSE(counts_maxima(Objective::none));
}

TEST(Objective, methods_are_for_some) {
  const Objective angle = objective_from_name("min-max-angle");
  EXPECT_THROW(check_method(Method::greedy, angle), ParameterError);
  EXPECT_THROW(check_method(Method::greedy, Objective::min_max_degree), ParameterError);
  EXPECT_NO_THROW(check_method(Method::greedy, Objective::min_local_extrema));
  for (const Method method : {Method::automatic, Method::flip, Method::exact}) {
    EXPECT_NO_THROW(check_method(method, angle));
    EXPECT_NO_THROW(check_method(method, Objective::min_local_minima));
  }
}

TEST(Objective, an_unknown_name_is_an_error_that_names_the_known) {
  for (const std::string name : {"", "min", "MIN-LOCAL-MINIMA", "min-local-minima "}) {
    try {
      objective_from_name(name);
      ADD_FAILURE() << name;
    } catch (const ParameterError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("'" + name + "'"), std::string::npos) << message;
      EXPECT_NE(message.find("min-local-minima"), std::string::npos) << message;
    }
  }
  EXPECT_THROW(method_from_name("best"), ParameterError);
}

}  // namespace
}  // namespace hodt
