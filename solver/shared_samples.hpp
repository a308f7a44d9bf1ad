// SPDX-License-Identifier: BSD-3-Clause
// Samples of a log, which its columns, and the copies of a problem, have in common and keep once.
#pragma once

#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace tiretherm::solver {

/// Times or values that do not change: copies share them.
class SharedSamples {
public:
    SharedSamples() : SharedSamples(std::vector<double>{}) {}
    SharedSamples(std::vector<double> all) : all_(std::make_shared<const std::vector<double>>(std::move(all))) {}
    SharedSamples(std::initializer_list<double> all) : SharedSamples(std::vector<double>(all)) {}

    operator const std::vector<double>&() const { return *all_; }
    [[nodiscard]] auto begin() const { return all_->begin(); }
    [[nodiscard]] auto end() const { return all_->end(); }
    [[nodiscard]] std::size_t size() const { return all_->size(); }
    [[nodiscard]] bool empty() const { return all_->empty(); }
    [[nodiscard]] const double* data() const { return all_->data(); }
    [[nodiscard]] double front() const { return all_->front(); }
    [[nodiscard]] double back() const { return all_->back(); }
    [[nodiscard]] const double& operator[](std::size_t i) const { return (*all_)[i]; }
    friend bool operator==(const SharedSamples& a, const SharedSamples& b) {
        return a.all_ == b.all_ || *a.all_ == *b.all_;
    }

private:
    std::shared_ptr<const std::vector<double>> all_;
};

}  // namespace tiretherm::solver
