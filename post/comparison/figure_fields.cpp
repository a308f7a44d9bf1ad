// SPDX-License-Identifier: BSD-3-Clause
// Converts figures to the unit in which users see a channel.

#include "post/comparison/figure_fields.hpp"

#include "post/comparison/comparison_sentences.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

Cell cell(const ComparedChannel& channel, double difference) {
    return {channel.unit.difference(difference), shown(channel, difference)};
}

DataTable::Row figures(const ComparedChannel& channel, const Figures& f, bool with_scatter) {
    const Cell scatter = cell(channel, f.scatter);
    return {{"samples", "samples", count(f.samples)},
            {"bias", "bias", {channel.unit.difference(f.bias), shown_signed(channel, f.bias)}},
            {"+-", "bias_deviation", cell(channel, f.bias_deviation)},
            {"rms", "rmse", cell(channel, f.rmse)},
            with_scatter ? Field("scatter", "scatter", scatter) : data_only("scatter", scatter.value),
            data_only("independent_samples", f.independent)};
}

DataTable::Row joined(DataTable::Row row, const DataTable::Row& rest) {
    row.insert(row.end(), rest.begin(), rest.end());
    return row;
}

}  // namespace tiretherm::post
