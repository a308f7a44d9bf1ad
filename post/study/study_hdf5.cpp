// SPDX-License-Identifier: BSD-3-Clause
// The runs of a study as an HDF5 file in SI units, one array for each quantity.

#include <functional>
#include <limits>

#include <fmt/format.h>

#include "post/fields/hdf5_file.hpp"
#include "post/study/study_tables.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// A study's file as it is written.
class StudyHdf5 {
public:
    StudyHdf5(const std::filesystem::path& path, const StudyRecord& study)
        : study_(study),
          source_(fmt::format("study of {}, tiretherm {}", study.case_name, study.version)),
          file_(path) {}

    void write() {
        file_.add_attribute("/", "format", "tiretherm study 1");
        write_study();
        write_inputs();
        write_outcomes();
        write_channels();
        file_.close();
    }

private:
    [[nodiscard]] Label label(const std::string& units, const std::string& meaning, const char* along = "/run") const {
        return {.units = units, .long_name = meaning, .source = source_, .coordinates = along};
    }

    void write_study() {
        file_.add_group("/study");
        const auto text = [&](const std::string& name, const std::string& value, const std::string& meaning) {
            file_.write("/study/" + name, value, label("1", meaning, ""));
        };
        text("title", study_.title, "title of the study");
        text("file", study_.study_file, "file the study was read from");
        text("text", study_.study_text, "text of that file");
        text("case", study_.case_name, "case that is varied");
        text("case_file", study_.case_file, "file of that case");
        text("tiretherm_version", study_.version, "version of tiretherm that wrote this file");
        file_.add_attribute("/study", "samples", static_cast<double>(study_.is_sampled ? study_.samples : 0));
        if (study_.critical) {
            file_.add_attribute("/study", "critical_temperature_in_K", *study_.critical);
        }
        std::vector<int> numbers;
        for (std::size_t r = 0; r < study_.outcomes.size(); ++r) {
            numbers.push_back(static_cast<int>(r) + 1);
        }
        file_.write("/run", numbers, 0, label("1", "number of each run, counted from 1", ""));
    }

    void write_inputs() {
        file_.add_group("/inputs");
        for (const StudyColumn& column : study_.columns) {
            const std::string path = "/inputs/" + plain(column.key);
            const std::string meaning =
                fmt::format("{} of the case, {}", column.key, column.is_drawn ? "drawn at random" : "varied on a grid");
            if (column.is_number) {
                file_.write(path, column.numbers, 0, label(column.udunits, meaning));
                file_.add_attribute(path, "units_as_written", column.unit);
            } else {
                file_.write(path, column.texts, label("1", meaning));
            }
        }
    }

    void write_outcomes() {
        std::vector<std::string> outcome;
        std::vector<std::string> layer;
        std::vector<std::string> zone;
        for (const StudyOutcome& run : study_.outcomes) {
            outcome.push_back(run.ok() ? "ok" : run.failure);
            layer.push_back(run.hottest_layer);
            zone.push_back(run.hottest_zone);
        }
        file_.write("/outcome", outcome, label("1", "\"ok\", or why the run has no result"));
        file_.add_group("/hottest");
        write("/hottest/temperature", "K", "highest temperature of the field over the run",
              [](const StudyOutcome& run) { return run.hottest; });
        write("/hottest/time", "s", "time of the highest temperature",
              [](const StudyOutcome& run) { return run.hottest_time; });
        file_.write("/hottest/layer", layer, label("1", "layer of the highest temperature"));
        file_.write("/hottest/zone", zone, label("1", "zone of the highest temperature, of a section"));
        for (std::size_t p = 0; p < study_.parts.size(); ++p) {
            const std::string path = "/critical/" + plain(study_.parts[p]);
            if (p == 0) {
                file_.add_group("/critical");
            }
            file_.add_group(path);
            write(path + "/hottest", "K", study_.parts[p] + ", highest temperature of the run",
                  [p](const StudyOutcome& run) { return run.parts[p].hottest; });
            write(path + "/critical", "K", study_.parts[p] + ", critical temperature",
                  [p](const StudyOutcome& run) { return run.parts[p].critical; });
        }
        write("/energy_closure", "1", "heat that is unaccounted for, over the heat turned over",
              [](const StudyOutcome& run) { return run.energy_closure; });
        write("/steps", "1", "time steps", [](const StudyOutcome& run) { return static_cast<double>(run.steps); });
    }

    void write_channels() {
        file_.add_group("/channels");
        for (std::size_t c = 0; c < study_.channels.size(); ++c) {
            const solver::Channel& channel = study_.channels[c];
            const std::string path = "/channels/" + plain(channel.name);
            const std::string units(solver::unit_of(channel.quantity));
            const std::string meaning = channel.meaning.empty() ? channel.name : channel.meaning;
            file_.add_group(path);
            write(path + "/final", units, meaning + ", at the end of the run",
                  [c](const StudyOutcome& run) { return run.channel_final[c]; });
            write(path + "/min", units, meaning + ", lowest of the run",
                  [c](const StudyOutcome& run) { return run.channel_min[c]; });
            write(path + "/max", units, meaning + ", highest of the run",
                  [c](const StudyOutcome& run) { return run.channel_max[c]; });
        }
    }

    void write(const std::string& path, const std::string& units, const std::string& meaning,
               const std::function<double(const StudyOutcome&)>& value) {
        std::vector<double> values;
        for (const StudyOutcome& run : study_.outcomes) {
            values.push_back(run.ok() ? value(run) : std::numeric_limits<double>::quiet_NaN());
        }
        file_.write(path, values, 0, label(units, meaning));
    }

    /// A slash would make a group.
    static std::string plain(std::string name) {
        for (char& c : name) {
            c = c == '/' ? '_' : c;
        }
        return name;
    }

    const StudyRecord& study_;
    std::string source_;
    Hdf5File file_;
};

}  // namespace

void write_study_hdf5(const std::filesystem::path& path, const StudyRecord& study) { StudyHdf5(path, study).write(); }

}  // namespace tiretherm::post
