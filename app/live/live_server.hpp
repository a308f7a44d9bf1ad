// SPDX-License-Identifier: BSD-3-Clause
// The port of a live session: one peer drives, any number look on, a browser gets the page. Nothing that comes over the
// wire opens a file.
#pragma once

#include <functional>
#include <string>

#include "app/live/live_tires.hpp"

namespace tiretherm::app::live {

/// Where to listen.
struct Place {
    std::string host;
    std::string port;  ///< "0": a free one
};

/// Serves until Ctrl-C, SIGTERM or the end of the time, in this thread.
/// @param seconds infinite: no end  @param ready called once with the address, "127.0.0.1:7000", and whether only this machine reaches it
/// @errors std::system_error where that place cannot be listened at
void serve(LiveTires& tires, const Place& place, double seconds,
           const std::function<void(const std::string& address, bool is_loopback)>& ready);

}  // namespace tiretherm::app::live
