// SPDX-License-Identifier: BSD-3-Clause
// State of a run between two steps as numbers, from which a resumed run ends with the same digits, and the archive that
// writes and reads it.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace tiretherm::solver {

/// The state of a run between two steps, as numbers: enough to go on and end with the same digits. What it belongs to
/// is for the keeper of the file to remember; a state of another problem is refused by its length.
struct Checkpoint {
    std::vector<double> numbers;
};

/// Checkpoints of a run: where it starts from, how often it leaves one, and who keeps them.
///
/// Leaving a checkpoint changes nothing in a run: it ends with the same digits whether, when and how often it left one.
struct Continuation {
    const Checkpoint* from = nullptr;  ///< null: from the beginning
    long every = 0;                    ///< accepted steps between checkpoints; 0: none
    std::function<void(const Checkpoint&)> keep;
    std::function<bool()> due{};  ///< asked before one is left; empty: always
};

/// Walks through the members of a state in one order, writing them to numbers or reading them back.
class Archive {
public:
    static Archive writing(std::vector<double>& numbers) { return Archive(&numbers, {}); }
    static Archive reading(std::span<const double> numbers) { return Archive(nullptr, numbers); }

    void operator()(double& value) {
        if (out_ != nullptr) {
            out_->push_back(value);
        } else if (next_ < in_.size()) {
            value = in_[next_++];
        } else {
            short_ = true;
        }
    }
    /// Whole numbers up to 2^53 and truths pass through a double unharmed.
    template <typename Whole>
    void whole(Whole& value) {
        auto number = static_cast<double>(value);
        (*this)(number);
        value = static_cast<Whole>(number);
    }
    void operator()(std::vector<double>& values) {
        for (double& value : values) {
            (*this)(value);
        }
    }

    [[nodiscard]] bool is_reading() const { return out_ == nullptr; }
    /// Numbers that are left to be read.
    [[nodiscard]] std::size_t left() const { return in_.size() - next_; }
    /// Whether exactly all numbers were read.
    [[nodiscard]] bool complete() const { return !short_ && next_ == in_.size(); }

private:
    Archive(std::vector<double>* out, std::span<const double> in) : out_(out), in_(in) {}

    std::vector<double>* out_;
    std::span<const double> in_;
    std::size_t next_ = 0;
    bool short_ = false;
};

}  // namespace tiretherm::solver
