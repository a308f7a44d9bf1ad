// SPDX-License-Identifier: BSD-3-Clause
// Diagnosis of quoted numbers over many experiments: which additions to a model predict experiments that took no part in
// fitting them, what they leave, and which measurement would tell them apart.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/assess/diagnosis.hpp"
#include "diagnosis/quoted/held_out.hpp"
#include "diagnosis/quoted/trials.hpp"

namespace tiretherm::diagnosis::quoted {

/// One addition by itself.
struct SingleAddition {
    Addition addition;
    AdditionFit fit{};  ///< to all experiments
    HeldOut held_out{};
    double rms_fitted = 0.0;  ///< of the rows that it was fitted to, total uncertainties: no proof of anything
    bool fits = false;        ///< nothing significant is left of these
    bool in_set = false;
};

/// Additions that are made together.
struct SetOfAdditions {
    std::vector<Addition> additions{};
    AdditionFit fit{};   ///< to all experiments
    HeldOut held_out{};  ///< over the model as it is
    HeldOut further{};   ///< over the set that was accepted before, or the model as it is
    HeldOut choice{};    ///< the same, with the set chosen anew for each experiment left out; where it was asked for
    double rms_fitted = 0.0;
    bool fits = false;

    /// "sidewall_convection.conductance + inner_gas.liner"
    [[nodiscard]] std::string name() const;
    /// With the values that fit all experiments. It refers to the additions.
    [[nodiscard]] std::vector<Applied> applied() const;
};

/// What some of the rows say.
struct Analysis {
    std::vector<bool> counts{};  ///< [rows]
    std::size_t n_rows = 0;
    std::vector<std::size_t> experiments{};  ///< that have such rows
    std::vector<std::size_t> off{};          ///< of these, where the model is further off than 2 u
    double rms = 0.0;                        ///< of the model as it is, in total uncertainties
    double kelvin = 0.0;
    double chi_squared = 0.0;
    double significance = 0.0;                 ///< standard deviations by which chi squared is too large
    std::vector<SingleAddition> attempts{};    ///< the best first
    std::size_t without_effect = 0;            ///< additions that move no row that counts
    std::vector<SetOfAdditions> sizes{};       ///< the best on experiments left out, of 1, 2 ... additions
    std::optional<SetOfAdditions> accepted{};  ///< the last of these that predicts better than what was accepted before
    /// Of the fewest additions with which nothing significant is left where they are fitted: the set that costs least, then
    /// others that fit about as well, each with one addition exchanged. Empty where no set agrees, or nothing is off.
    std::vector<SetOfAdditions> agreeing{};
    std::size_t n_agreeing = 0;  ///< of these, also those that are not kept
    std::vector<double>
        after{};  ///< [rows] changes with the accepted set, or else the best agreeing one, simulated together
    double surrogate_error = 0.0;  ///< largest difference of that from the fit's, total uncertainties
    double rms_after = 0.0;        ///< with these changes
    double significance_after = 0.0;
    std::vector<std::size_t> off_after{};
    std::vector<std::vector<std::string>> set{};  ///< names of explanations that these rows cannot tell apart
    /// As of a diagnosis of logs; `partial`: something helps, and much is left that is none of what was tried.
    Verdict verdict = Verdict::cannot_tell;
};

/// A measurement that would tell explanations apart.
struct NextMeasurement {
    std::string run{};
    std::string channel{};
    std::string one{};  ///< explanation
    std::string other{};
    double value_of_one = 0.0;  ///< degC
    double value_of_other = 0.0;
    double uncertainty = 0.0;  ///< K, that can be achieved: the median of those stated
    std::string input{};       ///< whose knowledge would add most to what the quoted numbers say; empty: none
    double input_gain = 0.0;   ///< by how much it raises chi squared between the two
};

struct QuotedDiagnosis {
    Numbers numbers;
    Analysis decidable{};  ///< by the rows that `validate` can decide: the verdict
    Analysis all{};        ///< by all measured rows, with the ranges of unknown inputs as uncertainties
    std::optional<NextMeasurement> next{};
    std::vector<std::string> not_simulated{};  ///< names of additions of which no simulation came to its end
    long simulations = 0;
    bool stopped = false;
};

/// @param trials of the same validation and model
[[nodiscard]] QuotedDiagnosis diagnose_quoted(const input::Validation& validation, Trials& trials, std::size_t model);

}  // namespace tiretherm::diagnosis::quoted
