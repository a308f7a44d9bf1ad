#include "diagnosis/diagnosis.hpp"

#include <algorithm>
#include <chrono>

#include "diagnosis/findings.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Local error of a step, K. At 10 mK the steps of a bench bias its loss by 0.3 standard deviations.
constexpr double step_error = 1e-3;

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

Diagnosis diagnose(const cases::Experiment& experiment, const Observations& observations,
                   const DiagnosisChoice& choice) {
    const auto begin = std::chrono::steady_clock::now();
    cases::Experiment fine = experiment;
    for (cases::MeasuredRun& run : fine.runs) {
        run.problem.settings.tolerance = std::min(run.problem.settings.tolerance, step_error);
    }
    Diagnosis result;
    Findings findings;
    findings.evidence = gather_evidence(fine, observations);
    result.status = findings.evidence.status;
    if (result.status.ok()) {
        inquire(findings);
        report(findings, result);
        if (choice.measure_gain) {
            measure_gain(findings, result);
        }
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

}  // namespace tiretherm::diagnosis
