// SPDX-License-Identifier: BSD-3-Clause
// The record that the readers of this thread write into, if there is one.
#include "input/toml/key_record.hpp"

#include <cassert>
#include <utility>

namespace tiretherm::input {

namespace {

thread_local KeyRecord* recording = nullptr;

}  // namespace

KeyRecord::KeyRecord() {
    assert(recording == nullptr);
    recording = this;
}

KeyRecord::~KeyRecord() { recording = nullptr; }

bool KeyRecord::is_on() { return recording != nullptr; }

void KeyRecord::add(KeyUse use) {
    if (recording != nullptr) {
        use.unit = use.spec.unit;
        recording->uses_.push_back(std::move(use));
    }
}

}  // namespace tiretherm::input
