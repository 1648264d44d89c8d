// Fewer steps that end where the Euler steps end.
#include "craze/model/relaxation/relaxation_schedule.h"

#include <gtest/gtest.h>

#include <cmath>

namespace craze {
namespace {

/// What the steps make of a mode of amplitude 1 and stiffness z: its force is −z times it.
double left_of_mode(const std::vector<RelaxationStep>& steps, double z) {
  double amplitude = 1, move = 0, kept = 1;
  for (const RelaxationStep& step : steps) {
    move = step.momentum * move - step.time_step * z * amplitude;
    amplitude += move;
    kept += step.weight * move;
  }
  return kept;
}

struct Case {
  double count, time_step;
};

// Stiffness up to 6: Δt = 1/3 is the largest that is stable.
constexpr double stiffness = 6;
const Case cases[] = {{3, 0.1},      {10, 0.1},  {50, 0.1}, {1000, 0.1}, {100000, 0.1},
                      {40, 1.0 / 3}, {20, 1e-3}, {1, 1e3},  {1, 3e4},    {7, 50}};

double expected(const Case& c, double z) {
  const double step = 1 - c.time_step * z;
  return c.time_step * stiffness <= 2 ? std::pow(step, c.count)
                                      : std::exp(-c.count * c.time_step * z);
}

TEST(RelaxationSchedule, EveryModeEndsWhereTheEulerStepsLeaveItToOnePercent) {
  for (const Case& c : cases) {
    const auto steps = accelerated_steps(c.count, c.time_step, stiffness);
    for (int i = 0; i <= 400; ++i) {
      // Most of the modes that are left lie close to 0.
      const double z = stiffness * std::pow(i / 400.0, 4);
      EXPECT_NEAR(left_of_mode(steps, z), expected(c, z), 0.01)
          << c.count << " steps of " << c.time_step << ", stiffness " << z;
    }
  }
}

TEST(RelaxationSchedule, NoModeGrowsWhateverTheTimeStep) {
  for (const Case& c : cases) {
    const auto steps = accelerated_steps(c.count, c.time_step, stiffness);
    for (int i = 0; i <= 1000; ++i) {
      EXPECT_LE(std::abs(left_of_mode(steps, stiffness * i / 1000)), 1 + 1e-9)
          << c.count << " steps of " << c.time_step;
    }
  }
}

TEST(RelaxationSchedule, SlowModesDecayAtTheRateOfTheFlow) {
  for (const Case& c : cases) {
    const auto steps = accelerated_steps(c.count, c.time_step, stiffness);
    const double time = c.count * c.time_step, z = 1e-4 / time;
    EXPECT_NEAR((1 - left_of_mode(steps, z)) / z, time, 1e-3 * time);
  }
}

TEST(RelaxationSchedule, StepsGrowWithTheRootOfTheTime) {
  const auto steps = [](double count) {
    return static_cast<double>(accelerated_steps(count, 0.1, stiffness).size());
  };
  EXPECT_NEAR(steps(10000) / steps(100), 10, 1);
  EXPECT_LE(steps(1000), 52);
}

}  // namespace
}  // namespace craze
