// One module on one host, as a scripted GCNP client.
#ifndef GEMINGA_TESTS_SIM_MODULE_HPP
#define GEMINGA_TESTS_SIM_MODULE_HPP

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "sim/client.hpp"
#include "sim/host.hpp"
#include "sim/ledger.hpp"
#include "sim/world.hpp"

namespace geminga::sim {

/// Says hello, offers and asks, and connects again when its daemon returns. Every offer and every wish has a port of
/// its own on its host, so that an event's address and port tell whose it is. What it says is entered into the ledger.
class Module {
 public:
  /// Something that it offers or asks for.
  struct Request {
    std::string text;
    std::string mode;
    std::uint16_t port = 0;
  };

  /// `index` tells it from the other modules in the ledger.
  Module(World& world, Ledger& ledger, Host& host, const std::string& name, std::uint32_t index);

  [[nodiscard]] Host& host() { return host_; }
  [[nodiscard]] Client& client() { return client_; }
  [[nodiscard]] const std::map<std::uint32_t, Request>& offers() const { return offers_; }

  /// Each returns the number of the request.
  std::uint32_t offer(const std::string& text, const std::string& mode);
  std::uint32_t wish(const std::string& text, const std::string& mode);
  void withdraw(std::uint32_t number);
  /// Connects and says everything, now and whenever the host is on again.
  void run();
  void end();
  /// Says everything at other ports from its next connection on, as a program does that remembers nothing.
  void forget();
  /// Enters what it was told; `line` is for complaints.
  void hear(std::string_view line, const gcnp::Statement& statement);

 private:
  void connect();
  void say_offer(std::uint32_t number, bool is_change);
  void say_wish(std::uint32_t number, bool is_change);
  void disappear(End why);
  void disappear(std::uint32_t number, const Request& request, bool is_wish, End why);
  [[nodiscard]] Place place_of(const Request& request) const { return {host_.number(), request.port}; }

  World& world_;
  Ledger& ledger_;
  Host& host_;
  Client& client_;
  std::uint32_t index_;
  std::uint32_t next_ = 1;
  bool is_running_ = false;
  std::map<std::uint32_t, Request> offers_;
  std::map<std::uint32_t, Request> wishes_;
};

}  // namespace geminga::sim

#endif
