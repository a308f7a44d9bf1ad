// SPDX-License-Identifier: BSD-3-Clause
// Table of an exam's results: how often the diagnosis was right for each kind and size of hidden effect.
#pragma once

#include <string>
#include <vector>

#include "hidden_effects/exam/exam_marks.hpp"

namespace hidden_effects {

/// How often something was right in the data sets of one kind and size.
struct Row {
    std::string group;     ///< "two_node, single, 10 sigma"
    std::string question;  ///< "detected"
    int right = 0;
    int count = 0;
    double must = 0.0;  ///< least share, 0: none is demanded

    [[nodiscard]] int wrong() const { return count - right; }
    /// Wrong answers that are exceeded in less than one exam of a hundred by a diagnosis that just does what it must.
    [[nodiscard]] int most_wrong() const;
};

/// Every question that applies, kind by kind and size by size.
[[nodiscard]] std::vector<Row> rows_of(const std::vector<Mark>& marks);
/// A line a row: counts, share with Wilson's 95 % interval, what must be.
[[nodiscard]] std::string table_of(const std::vector<Row>& rows);
/// What drawing and diagnosing a data set of each kind and size took on average, where one was evaluated at a time.
[[nodiscard]] std::string costs_of(const std::vector<Mark>& marks);
/// For each truth the first names that came, and how often.
[[nodiscard]] std::string confusions_of(const std::vector<Mark>& marks);
/// A line for each data set with a fault: bench, kind, size, seed, truth, verdict, set.
[[nodiscard]] std::string faults_of(const std::vector<Mark>& marks);

}  // namespace hidden_effects
