// SPDX-License-Identifier: BSD-3-Clause
// The only source of the program that includes MPI.

#include "app/mpi_ranks.hpp"

#ifdef TIRETHERM_MPI
#include <cstdlib>

#include <mpi.h>
#endif

namespace tiretherm::app {

#ifdef TIRETHERM_MPI

std::optional<MpiRanks> MpiRanks::join() {
    if (MPI_Init(nullptr, nullptr) != MPI_SUCCESS) {
        return std::nullopt;
    }
    std::atexit([] { MPI_Finalize(); });
    MpiRanks ranks;
    int number = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &number);
    ranks.rank_ = static_cast<std::size_t>(number);
    MPI_Comm_size(MPI_COMM_WORLD, &number);
    ranks.size_ = static_cast<std::size_t>(number);
    return ranks;
}

int MpiRanks::largest(int number) const {
    int most = number;
    MPI_Allreduce(&number, &most, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return most;
}

#else

std::optional<MpiRanks> MpiRanks::join() { return std::nullopt; }

int MpiRanks::largest(int number) const { return number; }

#endif

}  // namespace tiretherm::app
