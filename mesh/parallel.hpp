// SPDX-License-Identifier: BSD-3-Clause
// Threads, by OpenMP: independent tasks, each begun when a thread is free; and loops over the nodes of one large mesh, shared by a team.
// Whoever works in threads does it by these functions, so that what is nested is decided here: tasks of a task are shared, its loops are not.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <span>
#include <utility>
#include <vector>

#include <omp.h>

namespace tiretherm {

/// Threads for n tasks; inside a task, those that all tasks share. @param wanted 0: as many as OpenMP gives (OMP_NUM_THREADS, or all cores)
[[nodiscard]] inline int threads_for(std::size_t n, unsigned wanted = 0) {
    const int all = omp_in_parallel() != 0 ? omp_get_num_threads() : omp_get_max_threads();
    const auto most = wanted > 0 && omp_in_parallel() == 0 ? wanted : static_cast<std::size_t>(all);
    return static_cast<int>(std::clamp<std::size_t>(n, 1, most));
}

/// What a computation has to do with: a place of whoever began it, nullptr without one. The tasks of `in_parallel` have that of the thread that
/// shares them out.
inline thread_local void* of_computation = nullptr;

/// Does something n times, several at a time, each begun when a thread is free, in the order of its number. What it throws
/// first is thrown here when all that had been begun has ended; nothing more is begun then. A task may have tasks of its own,
/// which are shared with threads that have nothing else to do. Where there is one thread for all because there is one task,
/// the task may split its loops.
/// @param threads as in `threads_for`; more are not used inside the tasks either
template <typename Work>
void in_parallel(std::size_t n, const Work& work, unsigned threads = 0) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr thrown;
    void* const computation = of_computation;
    const auto work_on = [&] {
        void* const before =
            std::exchange(of_computation, computation);  // whoever waits for its own tasks may take one of another's
        for (std::size_t i = next++; i < n; i = next++) {
            try {
                work(i);
            } catch (...) {
#pragma omp critical(tiretherm_thrown)
                thrown = thrown ? thrown : std::current_exception();
                next = n;
            }
        }
        of_computation = before;
    };
    const int team = threads_for(n, threads);
    const auto share_out = [&] {
        for (int helper = 1; helper < team; ++helper) {
#pragma omp task default(shared)
            work_on();
        }
        work_on();
    };
    const bool is_inside = omp_in_parallel() != 0;
    const int before = omp_get_max_threads();
    if (!is_inside) {
        omp_set_num_threads(threads > 0 ? static_cast<int>(threads) : before);
    }
    if (team == 1) {
        work_on();
    } else if (is_inside) {  // NOLINT(bugprone-branch-clone): both share out, one of them beginning a parallel region
#pragma omp taskgroup
        share_out();  // the group waits for these tasks alone, not for those that this one is among
    } else {
#pragma omp parallel
#pragma omp single  // at its end all threads wait, and take what tasks there are, also those of tasks
        share_out();
    }
    if (!is_inside) {
        omp_set_num_threads(before);
    }
    if (thrown) {
        std::rethrow_exception(thrown);
    }
}

/// A loop is cut into at most this many ranges, of at least so many nodes each: by its length alone, so that a sum has the same
/// digits for any number of threads.
constexpr std::size_t most_ranges = 32;
constexpr std::size_t least_of_range = 2048;
/// Below this length the ranges are one thread's: waking another one costs more than it takes over.
constexpr std::size_t least_shared = 16 * least_of_range;

[[nodiscard]] constexpr std::size_t ranges_of(std::size_t n) {
    return std::clamp<std::size_t>(n / least_of_range, 1, most_ranges);
}

/// The threads of one computation on a large mesh, which share its loops. To hand over a loop costs about a microsecond, as those that
/// wait for the next one look for it for some dozen microseconds before they sleep; whoever comes late is not waited for. Each thread has
/// the same part of all loops of one length, so that what it needs is in its cache; when it has done that, it takes over from others.
class Team {
public:
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    /// Does work(), whose loops are shared, if they are long enough, by as many threads as OpenMP gives. What it throws is thrown here.
    /// @param n nodes of the mesh
    template <typename Work>
    static void with(std::size_t n, const Work& work);

    /// Of the thread whose loops are shared. nullptr: none are
    [[nodiscard]] static Team* of_this_thread() { return now_; }

    /// Calls body(i) for i from begin to end, each by any thread, in the order of their numbers. What it throws ends the program.
    template <typename Body>
    void share(std::size_t begin, std::size_t end, const Body& body) {
        const std::size_t n = parts_.size();
        for (std::size_t k = 0; k < n; ++k) {
            parts_[k].next.store(begin + k * (end - begin) / n, std::memory_order_relaxed);
            parts_[k].end = begin + (k + 1) * (end - begin) / n;
        }
        body_ = &body;
        call_ = [](const void* what, std::size_t i) { (*static_cast<const Body*>(what))(i); };
        open();
        work_on_loop(0);
        close();
    }

private:
    /// Of a loop, for one thread. Each is in a cache line of its own.
    struct alignas(64) Part {
        std::atomic<std::size_t> next{0};
        std::size_t end = 0;
    };
    explicit Team(int threads) : parts_(static_cast<std::size_t>(threads)) {}
    void open();
    void close();
    void work_on_loop(std::size_t thread) noexcept;
    void help(std::size_t thread);
    void dismiss();

    static thread_local Team* now_;
    std::atomic<std::uint32_t> state_{
        0};                    ///< helpers at work in the last eight bits; the rest is odd while a loop is open
    std::vector<Part> parts_;  ///< [threads]
    const void* body_ = nullptr;
    void (*call_)(const void*, std::size_t) = nullptr;
};

template <typename Work>
void Team::with(std::size_t n, const Work& work) {
    if (n < least_shared || omp_in_parallel() != 0 || omp_get_max_threads() == 1) {
        work();
        return;
    }
    std::exception_ptr thrown;
    Team team(omp_get_max_threads());
#pragma omp parallel
    if (omp_get_thread_num() > 0) {
        team.help(static_cast<std::size_t>(omp_get_thread_num()));
    } else {
        now_ = &team;
        try {
            work();
        } catch (...) {
            thrown = std::current_exception();
        }
        now_ = nullptr;
        team.dismiss();
    }
    if (thrown) {
        std::rethrow_exception(thrown);
    }
}

/// Calls body(i) for i from begin to end, each by any thread of the team, if there is one. What it throws ends the program then.
/// @param shared whether other threads may help
template <typename Body>
void split_loop(std::size_t begin, std::size_t end, bool shared, const Body& body) {
    if (Team* team = shared && end - begin > 1 ? Team::of_this_thread() : nullptr; team != nullptr) {
        team->share(begin, end, body);
        return;
    }
    for (std::size_t i = begin; i < end; ++i) {
        body(i);
    }
}

/// Calls body(range, begin, end) for all ranges of 0 to n.
template <typename Body>
void over_ranges(std::size_t n, const Body& body) {
    const std::size_t ranges = ranges_of(n);
    split_loop(0, ranges, n >= least_shared, [&](std::size_t k) { body(k, k * n / ranges, (k + 1) * n / ranges); });
}

/// Calls body(i) for i from 0 to n, in ranges.
template <typename Body>
void over_nodes(std::size_t n, const Body& body) {
    over_ranges(n, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            body(i);
        }
    });
}

/// What range(begin, end) gives of each range, joined in the order of the ranges.
template <typename Range, typename Join>
[[nodiscard]] auto joined_over_ranges(std::size_t n, const Range& range, const Join& join) {
    if (ranges_of(n) == 1) {
        return range(0, n);
    }
    std::array<decltype(range(n, n)), most_ranges> of_range{};
    over_ranges(n, [&](std::size_t k, std::size_t begin, std::size_t end) { of_range[k] = range(begin, end); });
    auto all = of_range[0];
    for (std::size_t k = 1; k < ranges_of(n); ++k) {
        all = join(all, of_range[k]);
    }
    return all;
}

/// take(value, i) from begin to end in four runs side by side, so that none waits for the one before; then join(a, b) of what they give.
template <typename Value, typename Take, typename Join>
[[nodiscard]] Value fold_side_by_side(std::size_t begin, std::size_t end, const Value& start, const Take& take,
                                      const Join& join) {
    std::array<Value, 4> runs{start, start, start, start};
    std::size_t i = begin;
    for (; i + 4 <= end; i += 4) {
        for (std::size_t k = 0; k < 4; ++k) {
            runs[k] = take(runs[k], i + k);
        }
    }
    for (; i < end; ++i) {
        runs[0] = take(runs[0], i);
    }
    return join(join(runs[0], runs[1]), join(runs[2], runs[3]));
}

template <typename Range>
[[nodiscard]] double sum_over_ranges(std::size_t n, const Range& range) {
    return joined_over_ranges(n, range, [](double a, double b) { return a + b; });
}

/// Sum of term(i) for i from 0 to n, range by range.
template <typename Term>
[[nodiscard]] double sum_over_nodes(std::size_t n, const Term& term) {
    return sum_over_ranges(n, [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t i = begin; i < end; ++i) {
            sum += term(i);
        }
        return sum;
    });
}

[[nodiscard]] inline double sum_of(std::span<const double> values) {
    return sum_over_nodes(values.size(), [&](std::size_t i) { return values[i]; });
}

/// The largest of a row of values, and the first place where it is.
struct Largest {
    double value = 0.0;
    std::size_t place = 0;
};

/// The largest value(i) >= 0 for i from 0 to n; what is no number is passed over.
template <typename Value>
[[nodiscard]] Largest largest_over_nodes(std::size_t n, const Value& value) {
    const auto of_range = [&](std::size_t begin, std::size_t end) {
        Largest most{0.0, begin};
        for (std::size_t i = begin; i < end; ++i) {
            const double here = value(i);
            most = here > most.value ? Largest{here, i} : most;
        }
        return most;
    };
    return joined_over_ranges(n, of_range, [](Largest a, Largest b) { return b.value > a.value ? b : a; });
}

/// @pre of one length
inline void copy_nodes(std::span<const double> from, std::span<double> to) {
    over_ranges(from.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        std::copy_n(from.data() + begin, end - begin, to.data() + begin);
    });
}

inline void clear_nodes(std::span<double> values) {
    over_ranges(values.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        std::fill_n(values.data() + begin, end - begin, 0.0);
    });
}

}  // namespace tiretherm
