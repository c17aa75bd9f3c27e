#include "hodt/hydrology/check_places.h"

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "hodt/base/error.h"

namespace hodt {
namespace {

const std::vector<Point> kPoints{{600000, 200000}, {601000, 200500}};

std::string refusal(const Places& places) {
  try {
    check_places(places, kPoints);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

std::string refusal_of_point(const Point& p) {
  return refusal({.points = {{600000, 200000}, p},
                  .polygons = {},
                  .source = "pits.geojson",
                  .part = "feature",
                  .part_of_point = {4, 7}});
}

std::string refusal_of_polygon(std::vector<std::vector<Point>> rings) {
  return refusal({.points = {}, .polygons = {{std::move(rings)}}});
}

TEST(CheckPlaces, a_point_may_be_as_far_as_the_points_are_wide) {
  EXPECT_EQ(refusal_of_point({599000, 200000}), "");
  EXPECT_EQ(refusal_of_point({602000, 201500}), "");
  EXPECT_EQ(refusal_of_point({600000, 199000}), "");
  for (const Point& far : {Point{598999, 200000},
                           {602001, 200000},
                           {600000, 198999},
                           {600000, 201501},
                           {7.4, 46.9},
                           {-1e308, 1e308}}) {
    const std::string message = refusal_of_point(far);
    EXPECT_NE(message.find("feature 7 of pits.geojson"), std::string::npos) << message;
    EXPECT_NE(message.find("x 600000 to 601000, y 200000 to 200500"), std::string::npos) << message;
    EXPECT_NE(message.find("coordinate system"), std::string::npos) << message;
  }
}

TEST(CheckPlaces, a_polygon_must_meet_the_box) {
  EXPECT_EQ(refusal_of_polygon({{{0, 0}, {9e5, 0}, {9e5, 9e5}}}), "");
  EXPECT_EQ(refusal_of_polygon({{{601000, 200500}, {601001, 200500}, {601000, 200501}}}), "");
  for (const Point& at : {Point{7.4, 46.9}, {601001, 200000}, {600000, 200501}}) {
    const std::string message = refusal_of_polygon({{at, {at.x + 0.1, at.y}, {at.x, at.y + 0.1}}});
    EXPECT_NE(message.find("polygon 0 of the places"), std::string::npos) << message;
    EXPECT_NE(message.find("outside the points"), std::string::npos) << message;
  }
}

TEST(CheckPlaces, what_is_no_place_is_refused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal_of_point({nan, 0}).find("no number"), std::string::npos);
  EXPECT_NE(refusal_of_polygon({}).find("three corners"), std::string::npos);
  EXPECT_NE(refusal_of_polygon({{{600000, 200000}, {600001, 200000}}}).find("three corners"),
            std::string::npos);
  EXPECT_NE(
      refusal_of_polygon({{{600000, 200000}, {600001, 200000}, {600001, nan}}}).find("no number"),
      std::string::npos);
}

TEST(CheckPlaces, one_polygon_must_hold_a_point) {
  const Polygon triangle{{{{0, 0}, {1, 0}, {0, 1}}}};
  const Places two{{}, {triangle, triangle}};
  Buffer<bool> holds(2, false);
  EXPECT_THROW(check_polygons_hold_points(two, holds), InputError);
  holds[1] = true;
  EXPECT_NO_THROW(check_polygons_hold_points(two, holds));
  EXPECT_NO_THROW(check_polygons_hold_points({}, Buffer<bool>()));
}

}  // namespace
}  // namespace hodt
