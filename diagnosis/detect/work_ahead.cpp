// SPDX-License-Identifier: BSD-3-Clause
// Adds up the pieces of work that follow, each by the simulations that it usually takes.

#include "diagnosis/detect/work_ahead.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr long most_steps = most_additions;
constexpr long most_fitted = 5;  ///< beside timing, at each step
constexpr long fewest_fitted = 2;
constexpr long most_tested = 3;
constexpr long per_fit = 3;  ///< predictions of all runs
constexpr long per_block = 4;
constexpr long parts_of_a_recording = 4;

WorkAhead operator+(WorkAhead a, WorkAhead b) { return {a.least + b.least, a.most + b.most}; }
WorkAhead operator*(long n, WorkAhead one) { return {n * one.least, n * one.most}; }

/// Each piece of a diagnosis by its simulations.
class Pieces {
public:
    explicit Pieces(const Course& course)
        : course_(course),
          fit_(per_fit * course.runs),
          left_out_(course.recordings == 1 ? parts_of_a_recording * per_block * course.runs
                                           : per_block / 2 * course.runs * course.recordings) {}

    /// From some work of the score tests on.
    [[nodiscard]] WorkAhead score_tests(Work from) const {
        WorkAhead all;
        const auto add = [&](Work work, long least, long most) {
            all = from <= work ? all + WorkAhead{least, most} : all;
        };
        add(Work::fitting_case, fit_, 2 * fit_);
        add(Work::signatures, course_.together > 0 ? course_.runs : 0, (course_.together / 12 + 2) * course_.runs);
        add(Work::signature, course_.alone * course_.runs, course_.alone * course_.runs);
        add(Work::noise, fit_, 3 * fit_);
        return all;
    }
    [[nodiscard]] WorkAhead choice_of_base() const { return {0, 3 * fit_ + 3 * left_out_}; }
    /// @param steps at most
    [[nodiscard]] WorkAhead search(long steps) const {
        const long timing = course_.channels + 1;
        return {0, steps * ((timing + most_fitted + 1) * fit_ + (most_tested + 1) * left_out_) +
                       2 * most_steps * (2 * fit_ + left_out_)};
    }
    /// Nothing better is found.
    [[nodiscard]] WorkAhead one_step() const {
        return {(course_.channels + fewest_fitted) * fit_, (course_.channels + fewest_fitted) * fit_};
    }
    [[nodiscard]] WorkAhead looking_back() const { return {0, 2 * most_steps * (2 * fit_ + left_out_)}; }
    [[nodiscard]] WorkAhead other_meshes() const {
        const WorkAhead one = score_tests(Work::fitting_case) + WorkAhead{fit_ + left_out_, fit_ + left_out_} +
                              one_step() + search(most_steps - 1);
        return course_.richer * one;
    }
    [[nodiscard]] WorkAhead end() const { return {0, 2 * left_out_ + 10 * course_.runs}; }

private:
    const Course& course_;
    long fit_;
    long left_out_;
};

}  // namespace

WorkAhead work_ahead(const Course& course, const Activity& now) {
    const Pieces pieces(course);
    switch (now.doing) {
        case Work::none:
            return {};
        case Work::fitting_case:
        case Work::signatures:
        case Work::signature:
        case Work::unknown_heat:
        case Work::noise: {
            WorkAhead tests = pieces.score_tests(now.doing);
            if (now.doing == Work::signature) {
                const long done = static_cast<long>(now.number > 0 ? now.number - 1 : 0) * course.runs;
                tests = tests + WorkAhead{-done, -done};
            }
            // A model without errors of its own needs neither base nor other meshes.
            const WorkAhead rest = pieces.choice_of_base() + pieces.search(most_steps) + pieces.other_meshes();
            return tests + WorkAhead{0, rest.most} + pieces.end();
        }
        case Work::left_out_data:
            return pieces.choice_of_base() + pieces.one_step() + pieces.search(most_steps - 1) + pieces.other_meshes() +
                   pieces.end();
        case Work::candidate:
        case Work::prediction:
            return pieces.search(most_steps - course.additions) + pieces.other_meshes() + pieces.end();
        case Work::looking_back:
            return pieces.looking_back() + pieces.other_meshes() + pieces.end();
        case Work::other_mesh:
            return pieces.other_meshes() + pieces.end();
        case Work::unknown_source:
        case Work::next_experiment:
            return pieces.end();
    }
    return {};
}

}  // namespace tiretherm::diagnosis
