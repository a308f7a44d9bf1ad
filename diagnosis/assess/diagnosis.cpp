#include "diagnosis/assess/diagnosis.hpp"

#include <algorithm>
#include <chrono>

#include "diagnosis/assess/findings.hpp"
#include "diagnosis/detect/own_error.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Local error of a step, K. At 10 mK the steps of a bench bias its loss by 0.3 standard deviations.
constexpr double step_error = 1e-3;
/// Standard deviations of the model's own error: from the first on it is corrected; the correction leaves a quarter of it at
/// most, as another halving would change a quarter of what the last one did; from the last on nothing can be said.
constexpr double noticed = 0.3;
constexpr double left_over = 0.25;
constexpr double too_coarse = 3.0;

}  // namespace

std::string_view word_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::named:
            return "named";
        case Verdict::confounded:
            return "confounded";
        case Verdict::unknown:
            return "unknown";
        case Verdict::consistent:
            return "consistent";
        case Verdict::cannot_tell:
            return "cannot_tell";
    }
    return "";
}

Diagnosis diagnose(const input::Experiment& experiment, const Observations& observations,
                   const DiagnosisChoice& choice) {
    const auto begin = std::chrono::steady_clock::now();
    input::Experiment fine = experiment;
    for (input::MeasuredRun& run : fine.runs) {
        run.problem.settings.tolerance = std::min(run.problem.settings.tolerance, step_error);
    }
    Diagnosis result;
    Findings findings;
    findings.evidence = gather_evidence(fine, observations, candidates_of(fine, fine.candidates), choice.progress);
    result.status = findings.evidence.status;
    Observations corrected = observations;
    bool is_coarse = false;
    if (result.status.ok() && !observations.channels.empty()) {
        const OwnError error = find_own_error(findings.evidence, choice.finer);
        result.numerical_error_sigma = error.sigma;
        if (error.sigma > noticed) {
            corrected.measured -= error.change;
            findings.evidence.take_observations(corrected);
            result.status = findings.evidence.status;
            result.numerical_error_sigma = left_over * error.sigma;
            is_coarse = result.numerical_error_sigma > too_coarse;
        }
    }
    if (result.status.ok() && is_coarse) {
        result.base = result.extended = findings.evidence.base.simulated;
        result.values = findings.evidence.base.values;
        result.noise = findings.evidence.noise.channels;
        result.simulations = findings.evidence.simulations;
        result.verdict = Verdict::cannot_tell;
    } else if (result.status.ok()) {
        inquire(findings);
        report(findings, result);
        ask_for_heat(findings, result);
        if (choice.measure_gain) {
            measure_gain(findings, result);
        }
        if (choice.plan_next) {
            plan_next(findings, result);
        }
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

}  // namespace tiretherm::diagnosis
