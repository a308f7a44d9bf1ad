// SPDX-License-Identifier: BSD-3-Clause
// Puts style, parts of the other pages and the charting library into live.html.

#include "post/page/live_page.hpp"

#include <string_view>

#include "post/page/assets.hpp"

namespace tiretherm::post {

std::string live_page() {
    std::string page(assets::live());
    const auto put = [&](std::string_view mark, std::string_view text) {
        page.replace(page.find(mark), mark.size(), text);
    };
    put("/*style*/", assets::style());
    put("/*charts*/", assets::charting_library());
    put("/*script*/", assets::live_script());
    return page;
}

}  // namespace tiretherm::post
