#pragma once

#include <vector>

#include "diagnosis/assess/diagnosis.hpp"
#include "diagnosis/assess/explanation.hpp"

namespace tiretherm::diagnosis {

/// The strongest of the unknown sources.
struct LoudTerm {
    std::size_t term = 0;
    double z = 0.0;

    [[nodiscard]] double gain() const { return 0.5 * z * z; }
};
[[nodiscard]] LoudTerm loudest_term(const Scores& scores);

/// What an inquiry has found so far, and what is to be made of it.
struct Findings {
    Evidence evidence;
    std::vector<Explanation> singles;  ///< causes alone, the most likely first
    std::vector<Explanation> pairs;
    LoudTerm unknown;
    Explanation unknown_fit;
    Verdict verdict = Verdict::cannot_tell;
    std::vector<const Explanation*> set;  ///< explanations that stand, the most likely first; point into the lists
    bool unknown_stands = false;          ///< the unknown source explains the data about as well as the set
    bool something_left = false;          ///< beside the best explanation

    /// The explanation that the model is extended with; null where there is none.
    [[nodiscard]] const Explanation* best() const;
};

/// Looks for explanations and decides between them: nothing, one cause, two causes, an unknown source.
void inquire(Findings& findings);

/// Measures the gain run by run: each run in turn takes no part in choosing, sizing and fitting, and is then predicted from
/// the others, with how it started from itself. To first order about the two fitted models.
void measure_gain(const Findings& findings, Diagnosis& into);

/// Rehearses manoeuvres of a menu and says by how many standard deviations each would set the likeliest explanations apart.
void plan_next(const Findings& findings, Diagnosis& into);

/// The heat that the residuals of the base model ask for, by the adjoint of the discrete run: one run backwards says for
/// every place and moment how the likelihood would rise with heat there. What noise makes of it is drawn.
void ask_for_heat(const Findings& findings, Diagnosis& into);

/// Tells a diagnosis what was found.
void report(const Findings& findings, Diagnosis& into);

}  // namespace tiretherm::diagnosis
