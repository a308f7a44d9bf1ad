#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input/model/draft.hpp"
#include "input/effects/own_effects.hpp"
#include "solver/sensitivity/adjustable.hpp"

namespace tiretherm::input {

/// The numbers that one [[parameter]] frees: where they are in the problem. Prior and bounds are read afterwards.
struct Freed {
    std::vector<solver::Adjustable> numbers;
    Wanted wanted;  ///< what their values must be
};

/// A parameter of an effect that is on, everywhere or at a place: effect, key, and patch, layer, zone or channel. An
/// effect of the user's own may be named here as well.
[[nodiscard]] std::optional<Freed> free_effect(Section& parameter, const Draft& draft, const Node& document);
/// The number of an effect of the user's own: source or exchange, and its key, which may be left out.
[[nodiscard]] std::optional<Freed> free_own(Section& parameter, const Draft& draft, const Node& document,
                                            const OwnKind& kind);
/// A number of a camera: camera, key.
[[nodiscard]] std::optional<Freed> free_camera(Section& parameter, const Draft& draft, const Node& document);
/// The law of a material by its values at one to three temperatures: material, law, at.
[[nodiscard]] std::optional<Freed> free_law(Section& parameter, const Draft& draft);
/// The law of the link between two lumps: link, at.
[[nodiscard]] std::optional<Freed> free_link(Section& parameter, const Draft& draft);
/// Initial temperatures, of each run: initial, one word or several.
[[nodiscard]] std::optional<Freed> free_initial(Section& parameter, const Draft& draft,
                                                const std::vector<std::string>& run_names);

}  // namespace tiretherm::input
