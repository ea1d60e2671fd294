// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <map>
#include <string>
#include <thread>

namespace frana::test {

/// Answers HTTP on a port of this machine: 404, or the text stored under a path; counts the calls.
class WebServer {
  public:
    WebServer();
    ~WebServer();
    WebServer(const WebServer&) = delete;
    WebServer& operator=(const WebServer&) = delete;

    /// "http://127.0.0.1:PORT"
    [[nodiscard]] std::string url() const { return "http://" + place(); }
    [[nodiscard]] std::string place() const { return "127.0.0.1:" + port(); }
    [[nodiscard]] std::string port() const { return std::to_string(port_); }
    /// Must be called before the first request.
    void put(const std::string& path, const std::string& text) { texts_[path] = text; }
    [[nodiscard]] int calls() const { return calls_; }

  private:
    void serve();
    void answer(int caller) const;

    int socket_;
    int port_ = 0;
    std::map<std::string, std::string> texts_;
    std::atomic<int> calls_ = 0;
    std::atomic<bool> ends_ = false;
    std::thread serving_;
};

}  // namespace frana::test
