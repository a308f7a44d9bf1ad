// SPDX-License-Identifier: BSD-3-Clause
// Kept states belong to the environment, which holds them by pointers, until it gives them back.

#include "interface/fmu/call.hpp"

#include <algorithm>
#include <memory>

namespace tiretherm::fmu {

namespace {

/// What an environment holds. Its first word points at itself: a simulator that is in use frees a state by the state in the place of
/// the address of its pointer, and finds the state there, too.
struct Handle {
    Handle* self = this;
    KeptState state;
};

Handle& handle_behind(void* state) {
    require(state != nullptr, "there is no state");
    auto& handle = *static_cast<Handle*>(state);
    require(handle.self == &handle, "this is no state");
    return handle;
}

/// Over the state that is there, or as a new one.
void put(KeptState state, void** into) {
    require(into != nullptr, "there is no place for a state");
    if (*into == nullptr) {
        *into = std::make_unique<Handle>().release();
    }
    handle_behind(*into).state = std::move(state);
}

}  // namespace

std::string doubled(const std::string& text, char special) {
    std::string result;
    for (const char c : text) {
        result.append(c == special ? 2 : 1, c);
    }
    return result;
}

int unsupported(void* instance, std::string_view name) {
    return call(instance, name, any_mode, [](Instance&) {
        throw std::logic_error("the FMU does not support this call, as its description says");
    });
}

int get_state(void* instance, std::string_view name, void** state) {
    return call(instance, name, any_mode, [&](Instance& it) { put(it.state(), state); });
}

int set_state(void* instance, std::string_view name, void* state) {
    return call(instance, name, any_mode, [&](Instance& it) { it.restore(handle_behind(state).state); });
}

int free_state(void* instance, std::string_view name, void** state) {
    return call(instance, name, any_mode, [&](Instance&) {
        if (state != nullptr && *state != nullptr) {
            const std::unique_ptr<Handle> freed(&handle_behind(*state));
            *state = nullptr;
        }
    });
}

int serialised_size(void* instance, std::string_view name, void* state, std::size_t* size) {
    return call(instance, name, any_mode, [&](Instance& it) {
        require(size != nullptr, "there is no place for the size");
        *size = it.serialised(handle_behind(state).state).size();
    });
}

int serialise(void* instance, std::string_view name, void* state, char* bytes, std::size_t size) {
    return call(instance, name, any_mode, [&](Instance& it) {
        const std::string all = it.serialised(handle_behind(state).state);
        require(bytes != nullptr && size >= all.size(), "there is not enough room for the state");
        std::ranges::copy(all, bytes);
    });
}

int deserialise(void* instance, std::string_view name, const char* bytes, std::size_t size, void** state) {
    return call(instance, name, any_mode, [&](Instance& it) {
        require(bytes != nullptr, "there are no bytes");
        put(it.deserialised({bytes, size}), state);
    });
}

}  // namespace tiretherm::fmu
