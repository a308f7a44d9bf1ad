// SPDX-License-Identifier: BSD-3-Clause
// The members of a struct one after the other, whatever they are called, so that none can be forgotten where all of them
// count: in a hash, in a journal.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

namespace tiretherm::solver {

/// Stands for a member of any type while members are counted.
struct AnyMember {
    template <typename T>
    operator T() const;
};

template <typename Whole, std::size_t... i>
constexpr bool has_members(std::index_sequence<i...> /*count*/) {
    return requires { Whole{(static_cast<void>(i), AnyMember{})...}; };
}

/// How many members a struct without constructors has.
template <typename Whole, std::size_t n = 0>
constexpr std::size_t count_members() {
    if constexpr (has_members<Whole>(std::make_index_sequence<n + 1>())) {
        return count_members<Whole, n + 1>();
    } else {
        return n;
    }
}

/// Calls take(member) for all of them, in their order. @pre an aggregate without a base, of at most 24 members
template <typename Whole, typename Take>
void for_each_member(Whole& whole, const Take& take) {
    constexpr std::size_t n = count_members<std::remove_const_t<Whole>>();
    static_assert(n > 0 && n <= 24, "add lines below");
    const auto take_all = [&](auto&... member) { (take(member), ...); };
// A wrong count does not compile: the names would be more or fewer than the members.
#define TIRETHERM_MEMBERS(count, ...) \
    if constexpr (n == (count)) {     \
        auto& [__VA_ARGS__] = whole;  \
        take_all(__VA_ARGS__);        \
    }
    TIRETHERM_MEMBERS(1, a)
    TIRETHERM_MEMBERS(2, a, b)
    TIRETHERM_MEMBERS(3, a, b, c)
    TIRETHERM_MEMBERS(4, a, b, c, d)
    TIRETHERM_MEMBERS(5, a, b, c, d, e)
    TIRETHERM_MEMBERS(6, a, b, c, d, e, f)
    TIRETHERM_MEMBERS(7, a, b, c, d, e, f, g)
    TIRETHERM_MEMBERS(8, a, b, c, d, e, f, g, h)
    TIRETHERM_MEMBERS(9, a, b, c, d, e, f, g, h, i)
    TIRETHERM_MEMBERS(10, a, b, c, d, e, f, g, h, i, j)
    TIRETHERM_MEMBERS(11, a, b, c, d, e, f, g, h, i, j, k)
    TIRETHERM_MEMBERS(12, a, b, c, d, e, f, g, h, i, j, k, l)
    TIRETHERM_MEMBERS(13, a, b, c, d, e, f, g, h, i, j, k, l, m)
    TIRETHERM_MEMBERS(14, a, b, c, d, e, f, g, h, i, j, k, l, m, o)
    TIRETHERM_MEMBERS(15, a, b, c, d, e, f, g, h, i, j, k, l, m, o, p)
    TIRETHERM_MEMBERS(16, a, b, c, d, e, f, g, h, i, j, k, l, m, o, p, q)
    TIRETHERM_MEMBERS(17, a, b, c, d, e, f, g, h, i, j, k, l, m, o, p, q, r)
    TIRETHERM_MEMBERS(18, a, b, c, d, e, f, g, h, i, j, k, l, m, o, p, q, r, s)
    TIRETHERM_MEMBERS(19, a, b, c, d, e, f, g, h, i, j, k, l, m, o, p, q, r, s, t)
    TIRETHERM_MEMBERS(20, a, b, c, d, e, f, g, h, i, j, k, l, m, o, p, q, r, s, t, u)
    TIRETHERM_MEMBERS(21, a, b, c, d, e, f, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v)
    TIRETHERM_MEMBERS(22, a, b, c, d, e, f, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w)
    TIRETHERM_MEMBERS(23, a, b, c, d, e, f, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, x)
    TIRETHERM_MEMBERS(24, a, b, c, d, e, f, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, x, y)
#undef TIRETHERM_MEMBERS
}

}  // namespace tiretherm::solver
