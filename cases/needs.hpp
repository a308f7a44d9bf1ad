#pragma once

#include "cases/draft.hpp"
#include "physics/effect.hpp"

namespace tiretherm::cases {

/// Why an effect cannot act in this case: no tire, none of its patches.
/// @param place where the case asks for it  @param chosen whether it chooses the patches
void check_needs(Section& root, const physics::ActiveEffect& active, const Place& place, bool chosen,
                 const Draft& draft);

/// Signals that active effects need and [drive] does not give.
void check_signals(Section& root, const Draft& draft);

/// Signals that are given and change nothing: a warning.
void warn_of_unread_signals(Section& root, const Draft& draft);

}  // namespace tiretherm::cases
