// SPDX-License-Identifier: BSD-3-Clause
// Which inputs a session looks at, and its model as bytes: a heading, the checksum, and all members in their order.

#include "solver/real_time/session_model.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "solver/digest.hpp"
#include "solver/quantity_inputs.hpp"
#include "solver/real_time/byte_archive.hpp"

namespace tiretherm::solver {

namespace {

/// The layout of the bytes is that of the structs; its size tells most builds apart.
std::string heading() {
    return fmt::format("tiretherm session {} {} {}\n", sizeof(Problem), sizeof(mesh::Mesh), sizeof(FreeParameter));
}

void visit(ByteArchive& archive, SessionModel& model) {
    archive(model.problem);
    archive(model.start);
    archive(model.parameters);
}

bool has(std::span<const std::string_view> names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
}

bool reads(const physics::ActiveEffect& active, std::string_view signal) {
    const physics::Effect& effect = *active.effect;
    if (has(effect.reads, signal) || has(effect.may_read, signal)) {
        return true;
    }
    for (std::size_t i = 0; i < active.choices.size(); ++i) {
        if (active.choices[i] > 0 && has(effect.choices[i].reads, signal)) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::vector<const physics::Signal*> SessionModel::inputs() const {
    std::vector<const physics::Signal*> found;
    for (const physics::Signal& signal : physics::signals()) {
        const bool by_effect =
            std::ranges::any_of(problem.effects, [&](const auto& active) { return reads(active, signal.name); });
        const bool by_channel = std::ranges::any_of(problem.channels, [&](const Channel& channel) {
            return has(description_of(channel.quantity).signals, signal.name) ||
                   has(optional_signals(channel.quantity), signal.name);
        });
        // An input that the case leaves out, and that cannot be nothing, does not act in it.
        const double now = start.*signal.member;
        if ((by_effect || by_channel) && now >= signal.low && now <= signal.high) {
            found.push_back(&signal);
        }
    }
    return found;
}

SessionModel session_model(const Problem& problem, const std::vector<FreeParameter>& parameters) {
    SessionModel model{.problem = problem, .start = problem.input_signals.at(problem.settings.start, JumpSide::after)};
    model.start.time = 0.0;
    std::ranges::copy_if(parameters, std::back_inserter(model.parameters),
                         [](const FreeParameter& parameter) { return parameter.kind != FreeParameter::Kind::input; });
    return model;
}

std::string to_bytes(const SessionModel& model) {
    SessionModel stored = model;
    stored.problem.mesh.drawing = {};
    stored.problem.measured.clear();
    stored.problem.sources.clear();
    std::string content;
    ByteArchive archive = ByteArchive::writing(content);
    visit(archive, stored);
    return heading() + token_of(content) + content;
}

SessionModel session_model_from(std::string_view bytes) {
    const std::string head = heading();
    if (!bytes.starts_with(head)) {
        throw std::runtime_error("the stored session is of another build of tiretherm");
    }
    constexpr std::size_t digits = 32;
    bytes.remove_prefix(head.size());
    const std::string_view content = bytes.substr(std::min(digits, bytes.size()));
    SessionModel model;
    ByteArchive archive = ByteArchive::reading(content);
    if (token_of(content) != bytes.substr(0, digits)) {
        throw std::runtime_error("the stored session is damaged");
    }
    visit(archive, model);
    if (!archive.complete()) {
        throw std::runtime_error("the stored session is of another build of tiretherm");
    }
    return model;
}

std::string token_of(std::string_view bytes) {
    Digest digest;
    digest.add(bytes);
    return fmt::format("{:016x}{:016x}", digest.value()[0], digest.value()[1]);
}

}  // namespace tiretherm::solver
