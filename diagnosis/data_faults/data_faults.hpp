// SPDX-License-Identifier: BSD-3-Clause
// Faults of the data that are told before any cause is looked for: readings and inputs whose labels are wrong.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/data_faults/relabelling.hpp"
#include "diagnosis/remarks/remark.hpp"

namespace tiretherm::diagnosis {

/// K, rms of all temperatures after a fit. What is left by less asks for no fault of the labels: a model without a cause of
/// usual size is off by 1 to 3 K.
inline constexpr double gross_misfit = 3.0;

/// A label that is wrong, and what the fitted model is off by with it and without.
struct DataFault {
    Relabelling what{};
    FaultScope scope{};
    std::vector<input::ColumnChange> changes{};  ///< that read the data as they are
    double before = 0.0;                         ///< K, rms of all temperatures after the fit
    double after = 0.0;                          ///< K, the same as the data are
    double pull_before = 0.0;                    ///< standard deviations of all priors together
    double pull_after = 0.0;
    Remark remark;  ///< what is wrong and what to correct
};

/// What corrects the data of an experiment.
struct DataCorrections {
    std::vector<input::ColumnChange> columns{};
    std::vector<std::size_t> mirrored{};  ///< indices into Experiment::runs

    /// Adds what corrects a fault.
    void add(const Relabelling& what, const FaultScope& scope, const input::Experiment& experiment);
};

/// The faults of an experiment, the first found first, and the experiment read without them.
struct DataFaults {
    std::vector<DataFault> found;
    DataCorrections corrections;                   ///< of all of them
    std::optional<input::Experiment> corrected{};  ///< nothing where none was found
    long simulations = 0;
};

/// Reads the experiment as it is corrected. @returns nothing where that cannot be
using ReadAgain = std::function<std::optional<input::Experiment>(const DataCorrections&)>;

/// Where the fitted model is grossly off, asks whether the data are right under other labels: units, exchanged columns.
/// A fault is told where the temperatures' rms after the fit falls to less than a third with it, to what an ordinary error of
/// a model is, where no other relabelling does nearly as well, and where it does not take parameters farther from what was
/// known of them. An input's unit is told, too, where it brings parameters back that are far from what was known of them. Faults are looked for one after another. What was found so far is returned when the user has asked for an end.
[[nodiscard]] DataFaults find_data_faults(const input::Experiment& experiment, const ReadAgain& read_again);

}  // namespace tiretherm::diagnosis
