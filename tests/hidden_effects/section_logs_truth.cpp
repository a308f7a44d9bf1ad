#include "section_logs_truth.hpp"

#include "random_truth.hpp"
#include "section_columns_truth.hpp"

namespace hidden_effects {

std::vector<ShippedLog> section_logs() {
    std::vector<ShippedLog> logs;
    for (std::uint64_t run = 1; run <= 3; ++run) {
        const SectionProgramme programme = draw_section_programme(400 + run);
        Random random(450 + run);
        const double start = programme.air_temperature.front() + 2.0 * random.normal();
        SectionTrace trace =
            drive_section({.lambda_h = 1.04, .lambda_sel = 0.95, .start = start, .gas_start = start}, programme);
        for (std::size_t c = 0; c < section_channels.size(); ++c) {
            const std::vector<double> noise =
                draw_noise({.standard_deviation = section_noise[c]}, programme.time, random);
            for (std::size_t i = 0; i < noise.size(); ++i) {
                trace.channel[c][i] += noise[i];
            }
        }
        logs.push_back({"practice/section_run" + std::to_string(run) + ".csv", section_columns(programme, trace)});
    }
    return logs;
}

}  // namespace hidden_effects
