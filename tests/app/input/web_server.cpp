// SPDX-License-Identifier: Apache-2.0
#include "web_server.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <sstream>

namespace frana::test {

WebServer::WebServer() : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* place = reinterpret_cast<sockaddr*>(&address);
    EXPECT_EQ(::bind(socket_, place, size), 0);
    EXPECT_EQ(::listen(socket_, 8), 0);
    EXPECT_EQ(::getsockname(socket_, place, &size), 0);
    port_ = ntohs(address.sin_port);
    serving_ = std::thread([this] { serve(); });
}

WebServer::~WebServer() {
    ends_ = true;
    serving_.join();
    ::close(socket_);
}

void WebServer::serve() {
    while (!ends_) {
        pollfd waiting{socket_, POLLIN, 0};
        if (::poll(&waiting, 1, 20) <= 0) continue;
        const int caller = ::accept(socket_, nullptr, nullptr);
        if (caller < 0) continue;
        ++calls_;
        answer(caller);
        ::close(caller);
    }
}

void WebServer::answer(int caller) const {
    std::string request;
    char bytes[4096];
    // A client that sends nothing for a second gets a response all the same.
    for (pollfd waiting{caller, POLLIN, 0}; request.find("\r\n\r\n") == std::string::npos;) {
        if (::poll(&waiting, 1, 1000) <= 0) break;
        const ssize_t count = ::recv(caller, bytes, sizeof bytes, 0);
        if (count <= 0) break;
        request.append(bytes, static_cast<std::size_t>(count));
    }
    std::istringstream words(request);
    std::string method, path;
    words >> method >> path;
    const auto text = texts_.find(path);
    const bool known = text != texts_.end();
    const std::string body = known ? text->second : "";
    std::string reply = std::string("HTTP/1.1 ") + (known ? "200 OK" : "404 Not Found") +
                        "\r\nConnection: close\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n";
    if (method != "HEAD") reply += body;
    for (std::size_t sent = 0; sent < reply.size();) {
        const ssize_t count = ::send(caller, reply.data() + sent, reply.size() - sent, MSG_NOSIGNAL);
        if (count <= 0) break;
        sent += static_cast<std::size_t>(count);
    }
}

}  // namespace frana::test
