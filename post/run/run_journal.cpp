// SPDX-License-Identifier: BSD-3-Clause
// Rows as records of a growing file; the checkpoint as a file of one record that is replaced as a whole.

#include "post/run/run_journal.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "post/report/file.hpp"

namespace tiretherm::post {

namespace {

constexpr const char* rows_name = "run.rows";
constexpr const char* state_name = "run.state";
constexpr const char* draft_name = "run.state.part";
/// What stands before the columns of a row.
struct RowHead {
    double time = 0.0;
    double stored = 0.0;
    bool has_field = false;
};
/// What stands before the numbers of the solver and of the follower in the state.
struct StateHead {
    std::size_t rows = 0;
    double time = 0.0;
    double seconds = 0.0;
    std::size_t of_solver = 0;
};
template <typename Head>
constexpr std::size_t length_of = solver::count_members<Head>();

template <typename Head>
Head head_of(std::span<const double> numbers) {
    Head head;
    solver::Archive archive = solver::Archive::reading(numbers.first(length_of<Head>));
    archive(head);
    return head;
}
template <typename Head>
std::vector<double> numbers_of(Head head) {
    std::vector<double> numbers;
    solver::Archive archive = solver::Archive::writing(numbers);
    archive(head);
    return numbers;
}

/// The share of the time that checkpoints may take.
constexpr double share = 0.02;

double seconds_between(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

}  // namespace

RunJournal::RunJournal(OutputFolder& folder, const solver::Digest::Value& identity, const solver::Problem& problem,
                       bool fresh)
    : rows_path_(folder.journal(rows_name)),
      state_path_(folder.journal(state_name)),
      draft_path_(folder.journal(draft_name)),
      identity_(identity),
      problem_(&problem),
      begin_(Clock::now()),
      last_(begin_) {
    std::error_code ignored;
    if (fresh || !std::filesystem::exists(state_path_, ignored)) {
        std::filesystem::remove(state_path_, ignored);
        std::filesystem::remove(rows_path_, ignored);
        return;
    }
    try {
        is_damaged_ = !read();
    } catch (const std::exception&) {
        is_damaged_ = true;
    }
    if (is_damaged_ || !kept_) {
        kept_.reset();
        rows_.reset();
        std::filesystem::remove(state_path_, ignored);
        std::filesystem::remove(rows_path_, ignored);
    }
}

bool RunJournal::read() {
    const RecordFile state(state_path_, identity_);
    if (state.size() != 1) {
        return state.dropped() == 0;
    }
    const std::vector<double> numbers = state.read(0);
    if (numbers.size() < length_of<StateHead>) {
        return false;
    }
    const auto head = head_of<StateHead>(numbers);
    rows_ = std::make_unique<RecordFile>(rows_path_, identity_);
    const bool is_whole = std::ranges::equal(numbers_of(head), std::span(numbers).first(length_of<StateHead>));
    if (!is_whole || head.rows > rows_->size() || head.of_solver > numbers.size() - length_of<StateHead>) {
        return false;
    }
    const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(length_of<StateHead>);
    const auto solver_end = first + static_cast<std::ptrdiff_t>(head.of_solver);
    Kept kept{.rows = head.rows,
              .time = head.time,
              .seconds = head.seconds,
              .solver = {.numbers = {first, solver_end}},
              .follower = {solver_end, numbers.end()}};
    const std::size_t bare = row_numbers();
    const std::size_t with_field = bare + static_cast<std::size_t>(problem_->mesh.n_nodes);
    for (std::size_t r = 0; r < kept.rows; ++r) {
        if (rows_->count(r) != bare && rows_->count(r) != with_field) {
            return false;
        }
    }
    rows_->truncate(kept.rows);  // rows after the checkpoint come again
    seconds_before_ = kept.seconds;
    kept_ = std::move(kept);
    return true;
}

std::size_t RunJournal::row_numbers() const {
    return length_of<RowHead> + problem_->channels.size() + 2 * problem_->effects.size();
}

void RunJournal::replay(const std::function<void(const solver::Snapshot&)>& take) {
    const std::size_t channels = problem_->channels.size();
    const std::size_t effects = problem_->effects.size();
    for (std::size_t r = 0; r < rows_->size(); ++r) {
        const std::vector<double> row = rows_->read(r);
        const bool field = row.size() > row_numbers();
        const auto head = head_of<RowHead>(row);
        const std::span<const double> all = std::span(row).subspan(length_of<RowHead>);
        take({.time = head.time,
              .temperature = field ? all.subspan(channels + 2 * effects) : std::span<const double>(),
              .channels = all.first(channels),
              .watts = all.subspan(channels, effects),
              .joules = all.subspan(channels + effects, effects),
              .stored = head.stored,
              .field = field});
    }
}

void RunJournal::take(const solver::Snapshot& snapshot) {
    last_time_ = snapshot.time;
    if (!works_) {
        return;
    }
    const std::size_t before = waiting_.size();
    const std::vector<double> head = numbers_of(RowHead{snapshot.time, snapshot.stored, snapshot.field});
    for (const std::span<const double> part :
         {std::span<const double>(head), snapshot.channels, snapshot.watts, snapshot.joules}) {
        waiting_.insert(waiting_.end(), part.begin(), part.end());
    }
    if (snapshot.field) {
        waiting_.insert(waiting_.end(), snapshot.temperature.begin(), snapshot.temperature.end());
    }
    lengths_.push_back(waiting_.size() - before);
}

bool RunJournal::due() const {
    return works_ && seconds_between(last_, Clock::now()) >= std::max(checkpoint_interval(), cost_ / share);
}

void RunJournal::keep(const solver::Checkpoint& checkpoint, const std::vector<double>& follower) noexcept {
    const Clock::time_point begin = Clock::now();
    try {
        if (!rows_) {
            rows_ = std::make_unique<RecordFile>(rows_path_, identity_);
            rows_->truncate(0);
        }
        std::span<const double> rest = waiting_;
        for (const std::size_t length : lengths_) {
            rows_->append(rest.first(length));
            rest = rest.subspan(length);
        }
        const std::vector<double> head =
            numbers_of(StateHead{.rows = rows_->size(),
                                 .time = last_time_,
                                 .seconds = seconds_before_ + seconds_between(begin_, begin),
                                 .of_solver = checkpoint.numbers.size()});
        std::error_code error;
        std::filesystem::remove(draft_path_, error);
        RecordFile(draft_path_, identity_).append({head, checkpoint.numbers, follower});
        std::filesystem::rename(draft_path_, state_path_);
        waiting_.clear();
        lengths_.clear();
    } catch (const std::exception&) {
        give_up();
    }
    last_ = Clock::now();
    cost_ = seconds_between(begin, last_);
}

/// A full disk is the results' before it is the journal's.
void RunJournal::give_up() noexcept {
    works_ = false;
    rows_.reset();
    waiting_ = {};
    lengths_ = {};
    std::error_code ignored;
    for (const std::filesystem::path* path : {&rows_path_, &state_path_, &draft_path_}) {
        std::filesystem::remove(*path, ignored);
    }
}

}  // namespace tiretherm::post
