// SPDX-License-Identifier: BSD-3-Clause
// The ranks of mpirun, where the program was built with MPI.
#pragma once

#include <cstddef>
#include <optional>

namespace tiretherm::app {

/// This process among those that mpirun began. MPI ends with the process.
class MpiRanks {
public:
    /// @returns nothing in a program that was built without MPI
    [[nodiscard]] static std::optional<MpiRanks> join();

    [[nodiscard]] std::size_t rank() const { return rank_; }  ///< from 0
    [[nodiscard]] std::size_t size() const { return size_; }
    /// Waits for all ranks. @returns the largest of their numbers
    [[nodiscard]] int largest(int number) const;

private:
    MpiRanks() = default;
    std::size_t rank_ = 0;
    std::size_t size_ = 1;
};

}  // namespace tiretherm::app
