// SPDX-License-Identifier: BSD-3-Clause
// Requirements for each kind of data set, counts with Wilson's interval, and lists of confusions and faults.

#include "hidden_effects/exam/exam_table.hpp"

#include <compare>
#include <functional>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "support/coverage.hpp"

namespace hidden_effects {

namespace {

struct Question {
    std::string text;
    std::function<bool(const Mark&)> applies;
    std::function<bool(const Mark&)> is_right;
    double must = 0.0;
    double from_sigma = 0.0;  ///< the size from which on it must
};

bool is_hidden(const Mark& m) { return !hides_nothing(m.kind); }
bool is_single(const Mark& m) { return m.kind == Kind::single || m.kind == Kind::dull_single; }
bool is_pair(const Mark& m) { return m.kind == Kind::pair; }
/// A pair that no other hypothesis, single or pair, comes near to. Where the nearest misses d standard deviations, data
/// tell the log likelihood ratio d^2/2 +- d: at d = 4 it exceeds 4.6, a hundred to one, in four data sets of five.
/// Nearer by, nobody can demand that three pairs of four be named alone.
bool stands_apart(const Mark& m) { return is_pair(m) && m.apart > 4.0; }
bool is_unknown_data_set(const Mark& m) { return is_unknown(m.kind); }

/// What the diagnosis is asked, with the least shares that are demanded of it.
const std::vector<Question>& questions() {
    static const std::vector<Question> all{
        {"no false alarm", [](const Mark& m) { return hides_nothing(m.kind); },
         [](const Mark& m) { return !m.false_alarm; }, 0.98},
        {"detected", is_hidden, [](const Mark& m) { return m.detected; }, 0.90, 6.0},
        {"right name first", is_single, [](const Mark& m) { return m.first_right; }},
        {"right name first, or one confounded with it", is_single, [](const Mark& m) { return m.first_right_or_alike; },
         0.90, 10.0},
        {"truth in the set, when detected", [](const Mark& m) { return (is_single(m) || is_pair(m)) && m.detected; },
         [](const Mark& m) { return m.in_set; }, 0.93},
        {"no wrong name with confidence", is_hidden, [](const Mark& m) { return !m.wrong_with_confidence; }, 0.97},
        {"the first pair is both and nothing else", is_pair, [](const Mark& m) { return m.first_right; }},
        {"both and nothing else", is_pair, [](const Mark& m) { return m.only_right; }, 0.75, 10.0},
        {"both in the set, no other near", stands_apart, [](const Mark& m) { return m.in_set; }, 0.93, 10.0},
        {"both and nothing else, no other near", stands_apart, [](const Mark& m) { return m.only_right; }, 0.75, 10.0},
        {"no name of the catalogue", is_unknown_data_set, [](const Mark& m) { return !m.named_though_unknown; }, 0.80,
         10.0},
        {"recognised as unknown", is_unknown_data_set, [](const Mark& m) { return m.unknown; }},
        {"its place", [](const Mark& m) { return m.unknown; }, [](const Mark& m) { return m.place_right; }},
        {"its signal", [](const Mark& m) { return m.unknown; }, [](const Mark& m) { return m.signal_right; }},
        {"size within its interval", [](const Mark& m) { return m.size_held.has_value(); },
         [](const Mark& m) { return *m.size_held; }, 0.88},
        {"gain confirmed on held-out runs", [](const Mark& m) { return m.removed.has_value(); },
         [](const Mark& m) { return m.confirmed; }},
    };
    return all;
}

struct Group {
    std::string bench;
    Kind kind = Kind::nothing;
    double sigma = 0.0;

    auto operator<=>(const Group&) const = default;
};

std::map<Group, std::vector<const Mark*>> grouped(const std::vector<Mark>& marks) {
    std::map<Group, std::vector<const Mark*>> groups;
    for (const Mark& mark : marks) {
        groups[{mark.bench, mark.kind, mark.sigma}].push_back(&mark);
    }
    return groups;
}

std::string name_of(const Group& group) {
    return fmt::format("{}, {}{}", group.bench, word_of(group.kind),
                       hides_nothing(group.kind) ? "" : fmt::format(", {:g} sigma", group.sigma));
}

}  // namespace

int Row::most_wrong() const {
    return must > 0.0 ? tiretherm::support::most_misses(count, 1.0 - must, 0.99) : std::numeric_limits<int>::max();
}

std::vector<Row> rows_of(const std::vector<Mark>& marks) {
    std::vector<Row> rows;
    for (const auto& [group, data_sets] : grouped(marks)) {
        for (const Question& question : questions()) {
            Row row{.group = name_of(group), .question = question.text};
            for (const Mark* mark : data_sets) {
                if (question.applies(*mark)) {
                    ++row.count;
                    row.right += question.is_right(*mark) ? 1 : 0;
                }
            }
            // A source that is no multiple of the throttle is counted, but nothing is demanded of it.
            const bool demanded = group.sigma >= question.from_sigma && group.kind != Kind::unknown_odd;
            row.must = demanded ? question.must : 0.0;
            if (row.count > 0) {
                rows.push_back(row);
            }
        }
    }
    return rows;
}

std::string table_of(const std::vector<Row>& rows) {
    std::string text;
    for (const Row& row : rows) {
        text += fmt::format("{:<30} {:<40} {:>4} of {:<4} {:5.1f} % ({:5.1f} to {:5.1f})", row.group, row.question,
                            row.right, row.count, 100.0 * row.right / row.count,
                            100.0 * tiretherm::support::wilson(row.right, row.count, -1),
                            100.0 * tiretherm::support::wilson(row.right, row.count, +1));
        if (row.must > 0.0) {
            const bool enough = row.right >= row.must * row.count;
            text += fmt::format("  must {:.0f} %{}", 100.0 * row.must, enough ? "" : "  BELOW");
        }
        text += '\n';
    }
    return text;
}

std::string costs_of(const std::vector<Mark>& marks) {
    std::string text;
    for (const auto& [group, data_sets] : grouped(marks)) {
        double draw = 0.0;
        double diagnose = 0.0;
        for (const Mark* mark : data_sets) {
            draw += mark->draw_seconds / static_cast<double>(data_sets.size());
            diagnose += mark->diagnose_seconds / static_cast<double>(data_sets.size());
        }
        text += fmt::format("{:<30} a data set takes {:.1f} s to draw and {:.1f} s to diagnose\n", name_of(group), draw,
                            diagnose);
    }
    return text;
}

std::string confusions_of(const std::vector<Mark>& marks) {
    std::map<std::pair<std::string, double>, std::map<std::string, int>> counts;
    for (const Mark& mark : marks) {
        ++counts[{mark.bench + ": " + mark.answer, mark.sigma}][mark.first];
    }
    std::string text;
    for (const auto& [truth, firsts] : counts) {
        text += fmt::format("{}{}:", truth.first, truth.second > 0.0 ? fmt::format(", {:g} sigma", truth.second) : "");
        for (const auto& [first, count] : firsts) {
            text += fmt::format("  {}{} {}", truth.first.ends_with(": " + first) ? "= " : "", first, count);
        }
        text += '\n';
    }
    return text;
}

std::string faults_of(const std::vector<Mark>& marks) {
    std::string text;
    for (const Mark& mark : marks) {
        if (const std::string faults = mark.faults(); !faults.empty()) {
            text += fmt::format("{} {} {:g} {}: {}; truth {}; {} {}\n", mark.bench, word_of(mark.kind), mark.sigma,
                                mark.seed, faults, mark.answer, mark.verdict, mark.set.empty() ? mark.first : mark.set);
        }
    }
    return text;
}

}  // namespace hidden_effects
