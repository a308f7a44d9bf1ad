// SPDX-License-Identifier: BSD-3-Clause
// The hash by which a kept result is found again follows all that a simulation follows.

#include <functional>

#include "solver/bench.hpp"
#include "solver/field_digest.hpp"
#include "solver/sensitivity/kept_results.hpp"

namespace tiretherm::solver {

namespace {

struct Inner {
    double a = 0.0;
    std::optional<int> b;
};

struct Outer {
    std::string name;
    std::vector<Inner> parts;
    std::array<bool, 2> flags{};
};

}  // namespace

// Two values count, and where each stands: [1], [] is not [], [1].
TEST(Members, OfAStructAreCountedAndHashedInTheirOrder) {
    EXPECT_EQ(count_members<Inner>(), 2U);
    EXPECT_EQ(count_members<Outer>(), 3U);
    EXPECT_EQ(count_members<Problem>(), 18U);
    const auto of = [](const Outer& value) {
        Digest digest;
        add_fields(digest, value);
        return digest.value();
    };
    const Outer one{.name = "x", .parts = {{.a = 1.0, .b = 0}}};
    EXPECT_EQ(of(one), of(one));
    for (const auto& change : std::vector<std::function<void(Outer&)>>{
             [](Outer& value) { value.name = "y"; }, [](Outer& value) { value.parts[0].a = 2.0; },
             [](Outer& value) { value.parts[0].b.reset(); }, [](Outer& value) { value.parts.emplace_back(); },
             [](Outer& value) { value.flags[1] = true; }}) {
        Outer other = one;
        change(other);
        EXPECT_NE(of(one), of(other));
    }
}

// Of a law that is held beyond its range only the ends change; none of its coefficients do.
TEST(KeptResults, AreThoseOfAProblemWithTheSameRangesAndTire) {
    const std::vector<double> times{0.0, 60.0};
    const auto key = [&](const std::function<void(Problem&)>& change) {
        Problem problem = two_node_tire();
        change(problem);
        return key_of(problem, {.times = times});
    };
    const auto as_it_is = key([](Problem&) {});
    EXPECT_EQ(as_it_is, key([](Problem&) {}));
    EXPECT_NE(as_it_is,
              key([](Problem& problem) { problem.link_laws[0] = problem.link_laws[0].within(280.0, 350.0); }));
    EXPECT_NE(as_it_is, key([](Problem& problem) { problem.tire.width *= 1.01; }));
    EXPECT_NE(as_it_is, key([](Problem& problem) { problem.mesh.stack = !problem.mesh.stack; }));
    EXPECT_NE(as_it_is, key([](Problem& problem) { problem.channels[0].standard_deviation = 0.5; }));
}

}  // namespace tiretherm::solver
