// SPDX-License-Identifier: BSD-3-Clause
// Data checks on measured signals (time jumps, stuck sensors, outliers, wrong units, unusual inputs) and the recording
// they look at.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/measurements/experiment.hpp"
#include "input/text/units.hpp"
#include "physics/signals.hpp"
#include "solver/shared_samples.hpp"

namespace tiretherm::input {

/// Samples of a sensor, one after another.
struct Stretch {
    std::size_t first = 0;  ///< index into RecordedColumn::value
    std::size_t length = 0;
};

/// Of a column that was brought to a higher rate: one sample of so many is a measured value.
struct Resampling {
    enum class How : std::uint8_t { none, held, linear, smooth };
    How how = How::none;
    std::size_t ratio = 1;
    std::size_t first = 0;  ///< measured sample, and every ratio-th from it on
};

/// Samples that leave the others at once and come back, and by how much they lie off.
struct Outlier {
    Stretch where;
    double height = 0.0;   ///< SI
    bool is_sure = false;  ///< of a temperature, so far off that no tire has it: it is left out
};

/// Something that is worked out when it is first asked for: several checks look at the same.
template <typename Value>
class Memo {
public:
    template <typename Make>
    [[nodiscard]] const Value& get(const Make& make) const {
        if (!known_) {
            known_ = make();
        }
        return *known_;
    }

private:
    mutable std::optional<Value> known_{};
};

/// A column of a run's file that the model uses, without its missing samples.
struct RecordedColumn {
    std::string name;            ///< what the model calls it
    std::string heading;         ///< what the file calls it
    std::string unit;            ///< as written
    std::string_view si;         ///< the unit of `value`
    Conversion conversion;       ///< from `unit` to `si`
    int line = 0;                ///< of the heading; 0: the file has no lines
    bool is_input = false;       ///< otherwise what a sensor read
    std::size_t series = 0;      ///< of a sensor: index into MeasuredRun::series
    solver::SharedSamples time;  ///< s
    solver::SharedSamples value;

    [[nodiscard]] bool is_temperature() const { return si == "K"; }
    [[nodiscard]] double low() const { return statistics().low; }    ///< below which a hundredth of the values lies
    [[nodiscard]] double high() const { return statistics().high; }  ///< above which a hundredth of the values lies
    [[nodiscard]] double least() const { return statistics().least; }
    [[nodiscard]] double most() const { return statistics().most; }
    [[nodiscard]] double largest() const;  ///< magnitude; a spike of one sample counts as twice its neighbours
    /// Smallest step between two samples, 0 without any.
    [[nodiscard]] double resolution() const { return statistics().resolution; }
    /// A value as the file would write it, to three digits: "27.8 km/h".
    [[nodiscard]] std::string show(double si_amount) const;
    /// A difference of two values: "41 K".
    [[nodiscard]] std::string show_difference(double si_amount) const;

    /// Of all values.
    struct Statistics {
        double least = 0.0;
        double most = 0.0;
        double low = 0.0;
        double high = 0.0;
        double resolution = 0.0;
    };
    /// @pre it has some
    [[nodiscard]] const Statistics& statistics() const;

    /// What has been found out: from then on `value` stays as it is.
    struct Known {
        Memo<Statistics> statistics{};
        Memo<std::vector<Stretch>> stretches{};
        Memo<std::vector<Stretch>> too_long{};
        Memo<std::vector<Stretch>> clipped{};
        Memo<std::vector<Stretch>> unusable{};
        Memo<std::vector<Outlier>> outliers{};
        Memo<Resampling> resampling{};
    } known{};
};

/// What was recorded in a run.
struct Recording {
    solver::SharedSamples time;  ///< s, of all samples
    std::string time_unit;       ///< as written
    std::vector<RecordedColumn> columns;
    bool keep_suspicious = false;  ///< what looks unusable counts all the same

    [[nodiscard]] const RecordedColumn* find(std::string_view name) const;  ///< null when the file does not have it
};

/// What is suspicious about a recording, a sentence each: jumps of time, stuck sensors, outliers, columns whose unit is
/// probably another one, unusual inputs. None of them is sure; a fit should not begin before somebody has looked.
[[nodiscard]] std::vector<std::string> find_suspicious(const Recording& recording);

/// Parts of it. Each sentence lacks the column's name; empty: nothing to say.
[[nodiscard]] std::string find_time_jumps(const Recording& recording);
/// Inputs that jump between samples; the whole sentence.
[[nodiscard]] std::string find_switched(const Recording& recording);
[[nodiscard]] std::string find_stuck(const Recording& recording, const RecordedColumn& column);
[[nodiscard]] std::string find_frozen(const Recording& recording, const RecordedColumn& column);
/// A sensor that has two values in all, while others move.
[[nodiscard]] std::string find_dead(const Recording& recording, const RecordedColumn& column);
[[nodiscard]] std::string find_clipped(const Recording& recording, const RecordedColumn& column);
/// Stretches of a temperature or a speed that stand still and are reached or left by a jump.
[[nodiscard]] std::string find_dead_stretches(const Recording& recording, const RecordedColumn& column);
/// Sensors that stand still in the same samples; the whole sentence.
[[nodiscard]] std::string find_stuck_together(const Recording& recording);
/// Columns that are copies of others, perhaps with a constant added; whole sentences.
[[nodiscard]] std::vector<std::string> find_copies(const Recording& recording);
[[nodiscard]] std::string find_resampled(const Recording& recording, const RecordedColumn& column);

/// What of a sensor is stuck, clipped, dropped to a rail or dead so surely that it is left out.
[[nodiscard]] const std::vector<Stretch>& unusable_stretches(const Recording& recording, const RecordedColumn& column);
[[nodiscard]] const Resampling& resampling_of(const RecordedColumn& column);

/// Leaves out of a run what its sensors did not measure, each of it found by the functions above: sensors that are frozen or
/// dead count as frozen, samples that are stuck, clipped, surely outliers or between the measured ones become missing.
void leave_out_unusable(const Recording& recording, MeasuredRun& run);
[[nodiscard]] const std::vector<Outlier>& outliers_of(const Recording& recording, const RecordedColumn& column);
[[nodiscard]] std::string find_outliers(const Recording& recording, const RecordedColumn& column);
[[nodiscard]] std::string find_unit_slip(const Recording& recording, const RecordedColumn& column);
/// The column with all units in which its numbers would have a usual size.
[[nodiscard]] ReadColumn with_other_units(const RecordedColumn& column);
[[nodiscard]] std::string find_unusual(const Recording& recording, const RecordedColumn& column);

/// To three digits, without an exponent where it can be helped: 4320, 27.8, 0.0421.
[[nodiscard]] std::string three_digits(double value);

}  // namespace tiretherm::input
