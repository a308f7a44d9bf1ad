// SPDX-License-Identifier: BSD-3-Clause
// What unused columns are compared with: inputs, what follows from two of them, and temperature sensors, at common samples.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "input/columns/column_course.hpp"
#include "input/measurements/experiment.hpp"

namespace tiretherm::input {

/// Samples of the runs at which courses are compared.
class CommonSamples {
public:
    /// @param n_columns that are going to be compared: of very many fewer samples are taken
    CommonSamples(const std::vector<MeasuredRun>& runs, std::size_t n_columns);

    /// @param value of the index of a run and a row of it
    template <typename Value>
    [[nodiscard]] Course of(Value value) const {
        Course course{.value = {}, .first = {0}};
        for (std::size_t r = 0; r < rows_.size(); ++r) {
            for (const std::size_t row : rows_[r]) {
                course.value.push_back(value(r, row));
            }
            course.first.push_back(course.value.size());
        }
        return course;
    }

private:
    std::vector<std::vector<std::size_t>> rows_;
};

/// What a column is compared with: an input, a product of two of them, or a sensor.
struct Reference {
    std::string name;
    Course course;
    std::vector<double> standard{};  ///< the course with mean 0 and standard deviation 1
};

/// Inputs that change, products and magnitudes of them, and temperature sensors that change, standardised.
[[nodiscard]] std::vector<Reference> changing_inputs(const std::vector<MeasuredRun>& runs,
                                                     const CommonSamples& samples);
/// What follows from one or two inputs: powers such as speed times force, and forces as magnitudes.
[[nodiscard]] std::vector<Reference> products_of(const std::vector<Reference>& inputs);
[[nodiscard]] std::vector<Reference> temperature_sensors(const std::vector<MeasuredRun>& runs,
                                                         const CommonSamples& samples);

}  // namespace tiretherm::input
