// SPDX-License-Identifier: BSD-3-Clause
// One thread, which waits for all sockets at once. A peer is answered before its next line is read, so one that does not read
// waits for itself alone; those that look on get the newest frame when the last one has gone out.

#include "app/live/live_server.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <memory>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <asio.hpp>

#include "post/page/live_page.hpp"

namespace tiretherm::app::live {

namespace {

using asio::ip::tcp;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::size_t longest_line = 65536;
constexpr int deepest = 3;
constexpr std::size_t most_peers = 256;
constexpr std::size_t most_unread = 1U << 20U;  // bytes that a peer may send to where nobody listens
constexpr int most_waiting = 1 << 16;  // bytes of frames on their way to one that looks on: it shall see new ones
constexpr std::chrono::seconds longest_silence{10};
constexpr milliseconds page_pause{50};
constexpr double endless = 1e9;  // s: longer limits do not fit into the clock, and nobody will see their end

std::string as_line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string http(std::string_view status, std::string_view type, const std::string& body) {
    return fmt::format(
        "HTTP/1.1 {}\r\nContent-Type: {}\r\nContent-Length: {}\r\nCache-Control: no-store\r\nConnection: "
        "close\r\n\r\n{}",
        status, type, body.size(), body);
}

/// Of the JSON library without its code in front, and without all of what was sent.
std::string sentence_of(const std::exception& error) {
    const std::string_view text = error.what();
    const std::size_t code = text.starts_with('[') ? text.find("] ") : std::string_view::npos;
    return std::string(text.substr(code == std::string_view::npos ? 0 : code + 2, 200));
}

/// A message, nested no deeper than one may be. @errors std::exception, whose what() is for the one that sent it
Json parse(std::string_view line) {
    constexpr const char* form =
        "a message is a JSON object in a line, such as {\"time\": 0, \"inputs\": {\"speed\": 30}}";
    const auto is_shallow = [](int depth, Json::parse_event_t, const Json&) {
        return depth <= deepest ? true : throw std::runtime_error(fmt::format("more than {} levels", deepest));
    };
    Json message;
    try {
        message = Json::parse(line, is_shallow);
    } catch (const std::exception& error) {
        throw std::runtime_error(sentence_of(error) + "; " + form);
    }
    return message.is_object() ? message : throw std::runtime_error(form);
}

class Server;

/// A peer: a program, one that looks on, or a browser.
class Peer : public std::enable_shared_from_this<Peer> {
public:
    Peer(tcp::socket socket, Server& server)
        : socket_(std::move(socket)), pause_(socket_.get_executor()), server_(server) {}

    void read();
    /// Sends the newest frame to one that looks on, unless the last one is still on its way.
    void offer();
    void say_and_close(std::string text);

private:
    enum class Role { talks, looks_on, is_page };

    void hear(std::size_t length);
    void answer_browser();
    void look_on(Role role, std::string first_words);
    template <typename Then>
    void say(std::string text, Then then);
    void ignore();
    void close();

    tcp::socket socket_;
    asio::steady_timer pause_;
    Server& server_;
    std::string heard_;
    std::string said_;
    std::array<char, 4096> ignored_{};
    std::size_t n_ignored_ = 0;
    Role role_ = Role::talks;
    bool is_sending_ = false;
    long seen_ = 0;  ///< number of the frame that was sent last
};

class Server {
public:
    Server(LiveTires& tires, const Place& place)
        : tires_(tires),
          hello_(as_line(tires.hello())),
          page_(post::live_page()),
          acceptor_(context_),
          signals_(context_, SIGINT, SIGTERM),
          end_(context_) {
        tcp::resolver resolver(context_);
        const auto found = resolver.resolve(place.host, place.port, tcp::resolver::passive);
        tcp::endpoint endpoint = found.begin()->endpoint();
        for (const auto& one : found) {
            if (one.endpoint().address().is_v4()) {
                endpoint = one.endpoint();
                break;
            }
        }
        acceptor_.open(endpoint.protocol());
        acceptor_.set_option(tcp::acceptor::reuse_address(true));
        acceptor_.bind(endpoint);
        acceptor_.listen();
        show(tires_.frame());
    }

    [[nodiscard]] tcp::endpoint endpoint() const { return acceptor_.local_endpoint(); }
    void run(double seconds);
    [[nodiscard]] std::string reply(Peer& peer, std::string_view line);
    void forget(Peer& peer);
    void shows_to(std::shared_ptr<Peer> peer) { lookers_on_.insert(std::move(peer)); }

    [[nodiscard]] long newest() const { return newest_; }
    [[nodiscard]] std::shared_ptr<const std::string> frame() const { return frame_; }
    [[nodiscard]] const std::string& hello() const { return hello_; }
    [[nodiscard]] const std::string& page() const { return page_; }

private:
    void accept();
    [[nodiscard]] Json drive(Peer& peer, const Json& message);
    void show(const Json& frame);

    asio::io_context context_{1};
    LiveTires& tires_;
    std::string hello_;
    std::string page_;
    tcp::acceptor acceptor_;
    asio::signal_set signals_;
    asio::steady_timer end_;
    std::set<Peer*> peers_;
    std::set<std::shared_ptr<Peer>> lookers_on_;
    Peer* driver_ = nullptr;
    Clock::time_point driven_{};
    std::shared_ptr<const std::string> frame_;
    long newest_ = 0;  ///< number of frame_
};

// --------------------------------------------------------------------------------------------------------- peers

template <typename Then>
void Peer::say(std::string text, Then then) {
    said_ = std::move(text);
    asio::async_write(socket_, asio::buffer(said_),
                      [self = shared_from_this(), then](const asio::error_code& error, std::size_t) {
                          error ? self->close() : then(*self);
                      });
}

void Peer::say_and_close(std::string text) {
    say(std::move(text), [](Peer& self) {
        asio::error_code ignored;
        self.socket_.shutdown(tcp::socket::shutdown_send, ignored);
        self.ignore();  // a socket that is closed with bytes unread takes back what it said
        self.pause_.expires_after(longest_silence);
        self.pause_.async_wait([peer = self.shared_from_this()](const asio::error_code&) { peer->close(); });
    });
}

void Peer::read() {
    asio::async_read_until(
        socket_, asio::dynamic_buffer(heard_, longest_line), '\n',
        [self = shared_from_this()](const asio::error_code& error, std::size_t length) {
            if (error == asio::error::not_found) {
                self->say_and_close(as_line(refusal({fmt::format(
                    "a line of more than {} bytes; the connection is closed: end each message with a new line",
                    longest_line)})));
            } else if (error) {
                self->close();
            } else {
                self->hear(length);
            }
        });
}

void Peer::hear(std::size_t length) {
    const std::string_view line = std::string_view(heard_).substr(0, length);
    if (line.find(" HTTP/1.") != std::string_view::npos && line.front() != '{') {
        asio::async_read_until(socket_, asio::dynamic_buffer(heard_, longest_line), "\r\n\r\n",
                               [self = shared_from_this()](const asio::error_code& error, std::size_t) {
                                   error ? self->close() : self->answer_browser();
                               });
        return;
    }
    std::string answer = server_.reply(*this, line);
    heard_.erase(0, length);
    if (answer.empty()) {
        look_on(Role::looks_on, server_.hello());
        return;
    }
    say(std::move(answer), [](Peer& self) { self.read(); });
}

void Peer::answer_browser() {
    const std::string_view request = std::string_view(heard_).substr(0, heard_.find('\r'));
    if (request.starts_with("GET / ")) {
        say_and_close(http("200 OK", "text/html; charset=utf-8", server_.page()));
    } else if (request.starts_with("GET /events ")) {
        look_on(
            Role::is_page,
            "HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\nCache-Control: no-store\r\nConnection: close\r\n\r\n"
            "event: hello\ndata: " +
                server_.hello() + "\n");
    } else {
        say_and_close(http(request.starts_with("GET ") ? "404 Not Found" : "405 Method Not Allowed", "text/plain",
                           "GET / is the page, GET /events its values\n"));
    }
}

void Peer::look_on(Role role, std::string first_words) {
    role_ = role;
    asio::error_code ignored;
    socket_.set_option(tcp::socket::send_buffer_size(most_waiting), ignored);
    server_.shows_to(shared_from_this());
    is_sending_ = true;
    say(std::move(first_words), [](Peer& self) {
        self.is_sending_ = false;
        self.offer();
    });
    ignore();
}

void Peer::offer() {
    if (is_sending_ || seen_ == server_.newest()) {
        return;
    }
    is_sending_ = true;
    const long skipped = seen_ > 0 ? server_.newest() - seen_ - 1 : 0;
    seen_ = server_.newest();
    const bool is_page = role_ == Role::is_page;
    said_ = is_page ? "data: " : skipped > 0 ? as_line({{"skipped", skipped}}) : "";
    const auto frame = server_.frame();
    const std::array<asio::const_buffer, 3> parts{asio::buffer(said_), asio::buffer(*frame),
                                                  asio::buffer("\n", is_page ? 1 : 0)};
    asio::async_write(socket_, parts,
                      [self = shared_from_this(), frame, is_page](const asio::error_code& error, std::size_t) {
                          if (error) {
                              self->close();
                              return;
                          }
                          self->pause_.expires_after(is_page ? page_pause : milliseconds(0));
                          self->pause_.async_wait([self](const asio::error_code&) {
                              self->is_sending_ = false;
                              self->offer();
                          });
                      });
}

void Peer::ignore() {
    socket_.async_read_some(asio::buffer(ignored_),
                            [self = shared_from_this()](const asio::error_code& error, std::size_t length) {
                                self->n_ignored_ += length;
                                error || self->n_ignored_ > most_unread ? self->close() : self->ignore();
                            });
}

void Peer::close() {
    asio::error_code ignored;
    socket_.close(ignored);
    pause_.cancel();
    server_.forget(*this);
}

// -------------------------------------------------------------------------------------------------------- server

void Server::run(double seconds) {
    const auto stop = [this](const asio::error_code& error, auto...) {
        if (!error) {
            context_.stop();
        }
    };
    signals_.async_wait(stop);
    if (seconds < endless) {
        end_.expires_after(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)));
        end_.async_wait(stop);
    }
    accept();
    context_.run();
}

void Server::accept() {
    acceptor_.async_accept([this](const asio::error_code& error, tcp::socket socket) {
        if (error) {  // no descriptor is left, for instance
            auto wait = std::make_shared<asio::steady_timer>(context_, milliseconds(100));
            wait->async_wait([this, wait](const asio::error_code&) { accept(); });
            return;
        }
        asio::error_code ignored;
        socket.set_option(tcp::no_delay(true), ignored);
        auto peer = std::make_shared<Peer>(std::move(socket), *this);
        if (peers_.size() < most_peers) {
            peers_.insert(peer.get());
            peer->read();
        } else {
            peer->say_and_close(
                as_line(refusal({fmt::format("{} peers are connected already; close one of them", most_peers)})));
        }
        accept();
    });
}

void Server::forget(Peer& peer) {
    peers_.erase(&peer);
    driver_ = driver_ == &peer ? nullptr : driver_;
    std::erase_if(lookers_on_, [&](const std::shared_ptr<Peer>& one) { return one.get() == &peer; });
}

/// @returns the line that answers; empty for one that wants to look on
std::string Server::reply(Peer& peer, std::string_view line) {
    try {
        const Json message = parse(line);
        if (message.contains("hello")) {
            return hello_;
        }
        return message.contains("observe") ? std::string() : as_line(drive(peer, message));
    } catch (const std::exception& error) {
        return as_line(refusal({sentence_of(error)}));
    }
}

Json Server::drive(Peer& peer, const Json& message) {
    const Clock::time_point now = Clock::now();
    if (driver_ != nullptr && driver_ != &peer && now - driven_ < longest_silence) {
        return refusal({"another peer drives; {\"observe\": true} looks on"});
    }
    const Json frame = driver_ != &peer || message.value("restart", Json(false)) == true ? tires_.begin(message)
                                                                                         : tires_.step(message);
    if (!frame.contains("errors")) {
        driver_ = &peer;
        driven_ = now;
        show(frame);
    }
    return frame;
}

void Server::show(const Json& frame) {
    frame_ = std::make_shared<const std::string>(as_line(frame));
    ++newest_;
    asio::post(context_, [this] {  // after the answer to the one that drives
        for (const std::shared_ptr<Peer>& peer : lookers_on_) {
            peer->offer();
        }
    });
}

}  // namespace

void serve(LiveTires& tires, const Place& place, double seconds,
           const std::function<void(const std::string& address, bool is_loopback)>& ready) {
    Server server(tires, place);
    const tcp::endpoint endpoint = server.endpoint();
    const std::string host = endpoint.address().to_string();
    ready(fmt::format("{}:{}", endpoint.address().is_v6() ? "[" + host + "]" : host, endpoint.port()),
          endpoint.address().is_loopback());
    server.run(seconds);
}

}  // namespace tiretherm::app::live
