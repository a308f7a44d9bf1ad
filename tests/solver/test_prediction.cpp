#include "solver/bench.hpp"
#include "solver/slopes.hpp"

namespace tiretherm::solver {

TEST(Prediction, SlopesOfTheTwoNodeTireEqualDifferences) {
    const Problem problem = two_node_tire();
    using Kind = Adjustable::Kind;
    expect_differences(
        problem, {number(problem, "air_convection", "lambda_h"), number(problem, "air_convection", "exponent"),
                  number(problem, "strain_energy_loss", "lambda_blk"), number(problem, "road_contact", "Hc"),
                  law(Kind::link_conductivity, {}, {333.15}, 0), law(Kind::link_conductivity, {}, {300.0, 360.0}, 1),
                  law(Kind::heat_capacity, {1}, {300.0}, 0), start_of(problem)});
}

}  // namespace tiretherm::solver
