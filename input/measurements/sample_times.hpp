// SPDX-License-Identifier: BSD-3-Clause
// Times of samples, which the columns of a log have in common and keep once.
#pragma once

#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace tiretherm::input {

/// A vector of times, s, that does not change: copies share it.
class SampleTimes {
public:
    SampleTimes() : SampleTimes(std::vector<double>{}) {}
    SampleTimes(std::vector<double> times) : times_(std::make_shared<const std::vector<double>>(std::move(times))) {}
    SampleTimes(std::initializer_list<double> times) : SampleTimes(std::vector<double>(times)) {}

    operator const std::vector<double>&() const { return *times_; }
    [[nodiscard]] auto begin() const { return times_->begin(); }
    [[nodiscard]] auto end() const { return times_->end(); }
    [[nodiscard]] std::size_t size() const { return times_->size(); }
    [[nodiscard]] bool empty() const { return times_->empty(); }
    [[nodiscard]] const double* data() const { return times_->data(); }
    [[nodiscard]] double front() const { return times_->front(); }
    [[nodiscard]] double back() const { return times_->back(); }
    [[nodiscard]] double operator[](std::size_t i) const { return (*times_)[i]; }
    friend bool operator==(const SampleTimes& a, const SampleTimes& b) {
        return a.times_ == b.times_ || *a.times_ == *b.times_;
    }

private:
    std::shared_ptr<const std::vector<double>> times_;
};

}  // namespace tiretherm::input
