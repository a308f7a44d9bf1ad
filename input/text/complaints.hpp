#pragma once

#include <fmt/format.h>

#include "input/text/mistake.hpp"

namespace tiretherm::input {

/// Mistakes of one kind, such as those of a column: five are reported, the others counted.
class Complaints {
public:
    explicit Complaints(Mistakes& mistakes) : mistakes_(&mistakes) {}

    void add(const Place& place, Fault fault) {
        if (++count_ <= shown) {
            mistakes_->add(place, std::move(fault));
        } else if (count_ == shown + 1) {
            next_ = place;
        }
    }
    /// Reports how many more there were. @param subject what they are about, such as a column's name
    void close(const std::string& subject) {
        if (count_ > shown) {
            mistakes_->add(next_, fmt::format("{}: and {} more like this", subject, count_ - shown));
        }
    }

private:
    static constexpr int shown = 5;
    Mistakes* mistakes_;
    int count_ = 0;
    Place next_;
};

}  // namespace tiretherm::input
