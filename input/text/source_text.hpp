// SPDX-License-Identifier: BSD-3-Clause
// The text of a file that was read, for messages that show a line of it.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace tiretherm::input {

/// A text that is kept, or let go once its numbers are read: then the file is read again by the message that needs it. Who reads a
/// case may do so in several threads.
class SourceText {
public:
    /// @param read_again gives the text as it was given first
    explicit SourceText(std::string text, std::function<std::string()> read_again = {})
        : text_(std::make_shared<const std::string>(std::move(text))), read_again_(std::move(read_again)) {}

    [[nodiscard]] bool is_empty() const { return size() == 0; }
    /// Bytes.
    [[nodiscard]] std::size_t size() const {
        const std::lock_guard lock(reading_);
        return text_ ? text_->size() : size_;
    }
    /// The text; empty where it was let go and the file is another one now.
    [[nodiscard]] std::shared_ptr<const std::string> get() const {
        const std::lock_guard lock(reading_);
        if (!text_) {
            std::string again = read_again_();
            const bool is_same = again.size() == size_ && std::hash<std::string>()(again) == hash_;
            text_ = std::make_shared<const std::string>(is_same ? std::move(again) : std::string());
        }
        return text_;
    }
    /// Whoever has it from `get` keeps it.
    void let_go() const {
        const std::lock_guard lock(reading_);
        if (text_ && read_again_) {
            size_ = text_->size();
            hash_ = std::hash<std::string>()(*text_);
            text_.reset();
        }
    }

private:
    mutable std::mutex reading_{};
    mutable std::shared_ptr<const std::string> text_;
    std::function<std::string()> read_again_;
    mutable std::size_t size_ = 0;  ///< of what was let go
    mutable std::size_t hash_ = 0;
};

}  // namespace tiretherm::input
