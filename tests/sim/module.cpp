#include "sim/module.hpp"

#include "base/text.hpp"

namespace geminga::sim {
namespace {

/// Providers are told of those who ask, but for a stream (paper section 3).
bool is_provider_told(const std::string& mode) { return mode != "otm/stream"; }

/// The host that an address belongs to: loopback is here, 10.HIGH.SEGMENT.LOW is number 256 HIGH + LOW, and
/// fe80::NUMBER that number. 0: none.
std::uint32_t host_of(std::string_view address, std::uint32_t here) {
  if (address == "127.0.0.1") return here;
  if (address.starts_with("fe80::")) {
    address.remove_prefix(6);
    return base::parse_number<std::uint32_t>(address.substr(0, address.find('%'))).value_or(0);
  }
  if (!address.starts_with("10.")) return 0;
  address.remove_prefix(3);
  const auto high = base::parse_number<std::uint32_t>(address.substr(0, address.find('.')));
  const auto low = base::parse_number<std::uint32_t>(address.substr(address.rfind('.') + 1));
  return high && low ? *high * 256 + *low : 0;
}

}  // namespace

Module::Module(World& world, Ledger& ledger, Host& host, const std::string& name, std::uint32_t index)
    : world_(world), ledger_(ledger), host_(host), client_(world.add_client(name)), index_(index) {
  client_.keeps_lines = false;
  client_.on_lost = [this] {
    if (!is_running_) return;
    disappear(host_.has_crashed() ? End::crashed : End::left);
    world_.after(std::chrono::milliseconds(100), [this] { connect(); });
  };
}

std::uint32_t Module::offer(const std::string& text, const std::string& mode) {
  const std::uint32_t number = next_++;
  offers_[number] = {.text = text, .mode = mode, .port = host_.take_port()};
  if (client_.is_connected()) say_offer(number, true);
  return number;
}

std::uint32_t Module::wish(const std::string& text, const std::string& mode) {
  const std::uint32_t number = next_++;
  wishes_[number] = {.text = text, .mode = mode, .port = host_.take_port()};
  if (client_.is_connected()) say_wish(number, true);
  return number;
}

void Module::withdraw(std::uint32_t number) {
  const bool is_wish = wishes_.contains(number);
  if (client_.is_connected()) {
    client_.say(std::to_string(number) + (is_wish ? " sub remove" : " pub remove"));
    disappear(number, is_wish ? wishes_.at(number) : offers_.at(number), is_wish, End::withdrawn);
  }
  offers_.erase(number);
  wishes_.erase(number);
}

void Module::run() {
  is_running_ = true;
  connect();
}

void Module::end() {
  is_running_ = false;
  disappear(End::withdrawn);
  client_.hang_up();
}

void Module::forget() {
  for (auto* requests : {&offers_, &wishes_}) {
    for (auto& [number, request] : *requests) request.port = host_.take_port();
  }
}

void Module::connect() {
  // A host that is off says at once that the connection is lost, and so it goes on.
  if (!is_running_ || client_.is_connected()) return;
  client_.connect(host_);
  if (!client_.is_connected()) return;
  client_.say("0 sys hello name=" + client_.name());
  for (const auto& [number, offer] : offers_) say_offer(number, false);
  for (const auto& [number, wish] : wishes_) say_wish(number, false);
}

void Module::say_offer(std::uint32_t number, bool is_change) {
  const Request& offer = offers_.at(number);
  client_.say(std::to_string(number) + " pub create mode=" + offer.mode + " text=" + offer.text +
              " port=" + std::to_string(offer.port));
  ledger_.begin(place_of(offer), {.is_request = false, .text = offer.text, .mode = offer.mode}, is_change);
  if (is_provider_told(offer.mode)) {
    ledger_.look({index_, number}, host_.number(), client_.name(),
                 {.is_request = true, .text = offer.text, .mode = offer.mode});
  }
}

void Module::say_wish(std::uint32_t number, bool is_change) {
  const Request& wish = wishes_.at(number);
  client_.say(std::to_string(number) + " sub create mode=" + wish.mode + " limit=0 text=" + wish.text +
              " port=" + std::to_string(wish.port));
  ledger_.look({index_, number}, host_.number(), client_.name(),
               {.is_request = false, .text = wish.text, .mode = wish.mode});
  if (is_provider_told(wish.mode)) {
    ledger_.begin(place_of(wish), {.is_request = true, .text = wish.text, .mode = wish.mode}, is_change);
  }
}

void Module::disappear(End why) {
  for (const auto& [number, offer] : offers_) disappear(number, offer, false, why);
  for (const auto& [number, wish] : wishes_) disappear(number, wish, true, why);
}

void Module::disappear(std::uint32_t number, const Request& request, bool is_wish, End why) {
  ledger_.look_away({index_, number});
  if (!is_wish || is_provider_told(request.mode)) ledger_.end(place_of(request), why);
}

void Module::hear(std::string_view line, const gcnp::Statement& statement) {
  const bool is_service = statement.command == "pub";
  if (!is_service && statement.command != "sub") return;
  const auto word = statement.value(is_service ? "service" : "subscription");
  if (!word) return;
  const Viewer viewer{index_, statement.id};
  if (statement.subcommand == "del") return ledger_.told_off(viewer, *word);
  const Place place{.host = host_of(statement.value("address").value_or(""), host_.number()),
                    .port = base::parse_number<std::uint16_t>(statement.value("port").value_or("")).value_or(0)};
  ledger_.told(viewer, *word, place, line);
}

}  // namespace geminga::sim
