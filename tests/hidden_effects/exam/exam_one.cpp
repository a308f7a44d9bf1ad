// SPDX-License-Identifier: BSD-3-Clause
// Draws one data set of the exam, diagnoses it and says what came of it:
//     exam_one [BENCH] KIND SIGMA SEED [FOLDER]
// BENCH: two_node (when left out), layers, section, laser. With a FOLDER its logs are written there too, for
// `tiretherm diagnose cases/practice/BENCH_bench.toml --data FOLDER/run1.csv ...`
#include <algorithm>
#include <exception>
#include <filesystem>

#include <fmt/format.h>

#include "hidden_effects/exam/exam_evaluation.hpp"
#include "post/report/remark_text.hpp"

namespace {

using namespace hidden_effects;
namespace diagnosis = tiretherm::diagnosis;

void print_truth(const ExamDataSet& data_set) {
    const Rig& rig = *data_set.runs.rig;
    fmt::print("truth      {}, {}", rig.name, answer_of(data_set));
    for (std::size_t i = 0; i < rig.of_bench.size(); ++i) {
        fmt::print("; {} {:.4f}", rig.of_bench[i].name, data_set.runs.of_bench[i]);
    }
    fmt::print("\n");
    for (std::size_t i = 0; i < data_set.hidden.size(); ++i) {
        for (const auto& [key, value] : data_set.hidden[i].parameters) {
            fmt::print("           {}.{} {:.6g}, oracle {:.2f} sigma\n", name_of(data_set.hidden[i]), key, value,
                       data_set.oracle[i]);
        }
    }
    if (is_unknown(data_set.kind)) {
        fmt::print("           {:.1f} W at most, oracle {:.2f} sigma; window: run {} {:g} to {:g} s\n",
                   data_set.source.watts, data_set.oracle.front(), data_set.source.run + 1, data_set.source.from,
                   data_set.source.to);
    }
    if (data_set.confounded) {
        fmt::print("           nearest other: {}, misses {:.2f} sigma\n", data_set.confounded->name,
                   data_set.confounded->apart);
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(5, data_set.alike.size()); ++i) {
        fmt::print("           like {} {:+.4f}\n", data_set.alike[i].variant->name(), data_set.alike[i].correlation);
    }
}

void print_diagnosis(const diagnosis::Diagnosis& found) {
    if (!found.status.ok()) {
        fmt::print("failed     {}\n", found.status.message);
    }
    fmt::print("verdict    {}: {}\n", diagnosis::word_of(found.verdict),
               found.reason ? tiretherm::post::text_of(*found.reason) : "");
    for (const auto& hypothesis : found.hypotheses) {
        std::string text;
        for (const std::size_t i : hypothesis) {
            text += (text.empty() ? "" : " + ") + name_of(found.causes[i]);
        }
        fmt::print("set        {}\n", text);
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(6, found.causes.size()); ++i) {
        const diagnosis::Cause& cause = found.causes[i];
        fmt::print("cause {:2}   {:<40} {:6.2f} sigma, gain {:8.2f}, probability {:.4f}{}\n", cause.rank,
                   name_of(cause), cause.sigma, cause.gain, cause.probability, cause.in_set ? ", in the set" : "");
        for (const diagnosis::CauseNumber& number : cause.numbers) {
            fmt::print("           {} {:.6g} ({:.6g} to {:.6g}) {}\n", number.key, number.value, number.low,
                       number.high, number.unit);
        }
    }
    if (found.unknown) {
        const diagnosis::UnknownSource& source = *found.unknown;
        fmt::print("unknown    {}, {}: {:.1f} W ({:.1f} to {:.1f}), {:.2f} sigma; {} {:g} to {:g} s{}\n", source.place,
                   source.follows, source.watts, source.low, source.high, source.sigma, source.run, source.from,
                   source.to, source.sensor ? "; a sensor" : "");
        for (const std::string& other : source.alike) {
            fmt::print("           or {}\n", other);
        }
    }
    for (const diagnosis::Noise& noise : found.noise) {
        fmt::print("noise      {:.4f}, {:.3f} over 1 s\n", noise.sigma, noise.rho_1s());
    }
    if (found.gain.measured) {
        fmt::print("gain       {:.3f} ({:.3f} to {:.3f}), log e {:.2f}{}\n", found.gain.removable_removed,
                   found.gain.low, found.gain.high, found.gain.log_e, found.gain.confirmed ? ", confirmed" : "");
    }
    for (const diagnosis::Remark& remark : found.remarks) {
        fmt::print("remark     {}\n", tiretherm::post::text_of(remark));
    }
    fmt::print("own error  {:.2f} sigma; {} simulations, {:.2f} s\n", found.numerical_error_sigma, found.simulations,
               found.seconds);
}

}  // namespace

int main(int count, char** words) {
    std::vector<std::string> said(words + 1, words + count);
    const std::string bench = !said.empty() && is_rig(said.front()) ? said.front() : "two_node";
    if (!said.empty() && said.front() == bench) {
        said.erase(said.begin());
    }
    if (said.size() < 3) {
        fmt::print(stderr,
                   "usage: exam_one [BENCH] KIND SIGMA SEED [FOLDER], for example exam_one layers single 10 1\n");
        return 1;
    }
    try {
        const ExamDataSet data_set =
            draw_data_set(kind_from(said[0]), std::stod(said[1]), std::stoull(said[2]), 0.0, rig_of(bench));
        for (std::size_t run = 0; said.size() > 3 && run < data_set.logs.size(); ++run) {
            write(std::filesystem::path(said[3]) / fmt::format("run{}.csv", run + 1), data_set.logs[run]);
        }
        print_truth(data_set);
        const diagnosis::Diagnosis found = diagnose_data_set(data_set);
        print_diagnosis(found);
        const std::string faults = mark_of(data_set, found).faults();
        fmt::print("faults     {}\n", faults.empty() ? "none" : faults);
    } catch (const std::exception& failure) {
        fmt::print(stderr, "{}\n", failure.what());
        return 1;
    }
    return 0;
}
