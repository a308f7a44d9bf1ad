// SPDX-License-Identifier: BSD-3-Clause
// What the reader of a result should know beside its numbers, as values: which remark it is, and what it is about.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace tiretherm::diagnosis {

struct Remark;
using Remarks = std::vector<Remark>;
/// A span of time, which is shown in seconds, minutes or hours.
using Seconds = std::chrono::duration<double>;

/// All remarks of remarks.list.
enum class RemarkCode : std::uint8_t {
#define REMARK(name, ...) name,
#include "diagnosis/remarks/remarks.list"
#undef REMARK
    count
};

/// A remark without words: those are made at one place, from these values.
struct Remark {
    RemarkCode code;
    /// Names, numbers in the unit in which they are shown, and remarks that are part of this one.
    std::vector<std::variant<std::string, double, long, Seconds, Remarks>> about{};

    friend bool operator==(const Remark& a, const Remark& b);
};

/// Makes remarks of one code. @tparam About what such a remark is about
template <typename... About>
struct RemarkKind {
    RemarkCode code;

    [[nodiscard]] Remark operator()(About... about) const { return {code, {std::move(about)...}}; }
};

inline bool operator==(const Remark& a, const Remark& b) { return a.code == b.code && a.about == b.about; }

/// The kinds by their names: `remark::thinned("run1", 20.0, 2.0, 10)`.
namespace remark {
#define REMARK(name, ...) inline constexpr RemarkKind<__VA_ARGS__> name{RemarkCode::name};
#include "diagnosis/remarks/remarks.list"
#undef REMARK
}  // namespace remark

}  // namespace tiretherm::diagnosis
