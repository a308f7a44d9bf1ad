// SPDX-License-Identifier: BSD-3-Clause
// A heat source, q = amount s(t), or a heat transfer, q = amount s(t) (T_surroundings(t) - T), that a user adds to a
// problem, following any signal s.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "solver/problem.hpp"

namespace tiretherm::solver {

/// A signal along a run, linear between its points and held beyond them. Two points at one time are a jump.
struct SignalHistory {
    std::vector<double> time;   ///< s, as in the input signals and in a measured run; not descending
    std::vector<double> value;  ///< [time]; what is not finite counts as missing
};

/// A user effect: heat into named parts of the mesh, or their exchange with surroundings, following a
/// signal.
///
///   source:    q = amount s(t)                            amount in W at a signal of 1
///   exchange:  q = amount s(t) (T_surroundings(t) - T)    amount in W/K at a signal of 1
struct UserEffect {
    std::string name;                 ///< what reports call it; no other effect of the problem has it
    std::string follows;              ///< what the signal is, as a case says it: "speed * abs(lateral_force)"
    std::vector<std::string> places;  ///< regions, layers, zones or patches: "surface"
    bool exchange = false;
    SignalHistory signal;          ///< the signal, in SI base units where it comes from a log
    double amount = 0.0;           ///< W, or W/K
    std::string temperature{};     ///< of an exchange, as a case says it; empty: the air's
    SignalHistory surroundings{};  ///< K; empty: the air's temperature
};

/// One thing that is wrong with a user effect.
struct UserEffectDefect {
    std::string what;                 ///< a sentence
    bool is_negative_signal = false;  ///< of an exchange, whose conductance follows the signal
    bool operator==(const UserEffectDefect&) const = default;
};

/// What is wrong with it for this problem; empty when it can be switched on.
[[nodiscard]] std::vector<UserEffectDefect> defects(const Problem& problem, const UserEffect& user_effect);

/// Switches it on. Its size is the first parameter of the effect (`watts` or `conductance`), which a fit may move; it
/// counts from the run's start, so the input signals must know that. They learn at which times the signal has samples and
/// where it jumps; no input is added to them.
/// @returns its index in problem.effects
/// @errors std::invalid_argument with the first of the defects; the problem is left untouched
std::size_t add_user_effect(Problem& problem, const UserEffect& user_effect);

/// Index of a user effect by its name, problem.effects.size() when there is none.
[[nodiscard]] std::size_t find_user_effect(const Problem& problem, std::string_view name);

/// Gives a heat source a law in the place of its number. @returns false where the problem has no heat source of this name
[[nodiscard]] bool give_law(Problem& problem, std::string_view name, std::shared_ptr<const physics::OwnLaw> law);
/// Gives the laws of a problem to another one that was read of the same case.
void take_laws(const Problem& from, Problem& to);

}  // namespace tiretherm::solver
