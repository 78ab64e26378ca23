#include "sim/team.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace geminga::sim {
namespace {

constexpr base::Duration check_period = std::chrono::milliseconds(500);
/// A clash is found by the next announcement that gets through, and mended by a claim.
constexpr base::Duration longest_clash = std::chrono::seconds(5);

std::string place(std::uint32_t host, std::uint16_t port) { return std::to_string(host) + ":" + std::to_string(port); }

}  // namespace

Module::Module(World& world, Host& host, const std::string& name)
    : world_(world), host_(host), client_(world.add_client(name)) {
  client_.keeps_lines = false;
  client_.on_lost = [this] {
    if (is_running_) world_.after(std::chrono::milliseconds(100), [this] { connect(); });
  };
}

std::uint32_t Module::offer(const std::string& text, const std::string& mode) {
  const std::uint32_t number = next_++;
  const std::uint16_t port = host_.take_port();
  offers_[number] = {.text = text, .mode = mode, .port = port};
  client_.say(std::to_string(number) + " pub create mode=" + mode + " text=" + text + " port=" + std::to_string(port));
  return number;
}

std::uint32_t Module::wish(const std::string& text, const std::string& mode) {
  const std::uint32_t number = next_++;
  wishes_[number] = {.text = text, .mode = mode};
  client_.say(std::to_string(number) + " sub create mode=" + mode + " limit=0 text=" + text);
  return number;
}

void Module::withdraw(std::uint32_t number) {
  client_.say(std::to_string(number) + (offers_.contains(number) ? " pub remove" : " sub remove"));
  offers_.erase(number);
  wishes_.erase(number);
}

void Module::run() {
  is_running_ = true;
  connect();
}

void Module::end() {
  is_running_ = false;
  client_.hang_up();
}

void Module::connect() {
  if (!is_running_ || client_.is_connected()) return;
  client_.connect(host_);  // A host that is off says at once that the connection is lost, and so it goes on.
  if (!client_.is_connected()) return;
  client_.say("0 sys hello name=" + client_.name());
  for (const auto& [number, offer] : offers_) {
    client_.say(std::to_string(number) + " pub create mode=" + offer.mode + " text=" + offer.text +
                " port=" + std::to_string(offer.port));
  }
  for (const auto& [number, wish] : wishes_) {
    client_.say(std::to_string(number) + " sub create mode=" + wish.mode + " limit=0 text=" + wish.text);
  }
}

Team::Team(World& world, Bounds bounds) : world_(world), bounds_(bounds) {
  world_.every(check_period, [this] {
    check_views();
    check_identifiers();
  });
}

Module& Team::add(Host& host, const std::string& name) {
  modules_.push_back(std::make_unique<Module>(world_, host, name));
  watch(*modules_.back());
  return *modules_.back();
}

void Team::watch(Module& module) {
  module.client().on_line = [this, &module](std::string_view line, const gcnp::Statement& statement) {
    see(module, line, statement);
  };
}

void Team::see(Module& module, std::string_view line, const gcnp::Statement& statement) {
  if (statement.command == "pub" || statement.command == "sub") ++events_;
  EXPECT_TRUE(statement.command == "pub" || statement.command == "sub" || statement.command == "msg")
      << "an error where none is due. " << world_.when() << ", " << module.client().name() << ": " << line;
  if (statement.subcommand != "del" || statement.value("reason") != "expired") return;
  const std::string participant(statement.value("service").value_or("").substr(0, 8));
  for (const auto& other : modules_) {
    // The very participant that is said to be gone still serves this module.
    const bool is_well = other->client().is_connected() && other->client().participant() == participant &&
                         other->host().island() == module.host().island();
    if (!is_well || is_excused) continue;
    false_departures_.insert(world_.when() + ", " + module.host().name() + " about " + other->host().name());
    return;
  }
}

Team::Offered Team::offered() const {
  Offered offered;
  for (const auto& provider : modules_) {
    const Host& host = provider->host();
    if (!provider->client().is_connected()) continue;
    for (const auto& [number, offer] : provider->offers()) {
      offered[{host.island(), offer.text, offer.mode}].insert(place(host.number(), offer.port));
    }
  }
  return offered;
}

Team::Places Team::seen(Module& consumer, std::uint32_t wish) {
  Places places;
  for (const auto& [service, event] : consumer.client().view(wish)) {
    const std::string address(event.value("address").value_or(""));
    // Each address is one that works where it was told: loopback here, 10.0.SEGMENT.HOST elsewhere.
    const std::string host =
        address == "127.0.0.1" ? std::to_string(consumer.host().number()) : address.substr(address.rfind('.') + 1);
    const auto [at, is_new] = places.insert(host + ":" + std::string(event.value("port").value_or("")));
    if (!is_new) places.insert(*at + " again as " + service);
  }
  return places;
}

bool Team::is_right() const { return complaints().empty(); }

std::string Team::complaints() const {
  std::string text;
  static const Places nothing;
  const Offered offers = offered();
  for (const auto& module : modules_) {
    if (!module->client().is_connected()) continue;
    for (const auto& [number, wish] : module->wishes()) {
      const auto found = offers.find({module->host().island(), wish.text, wish.mode});
      const Places& should = found == offers.end() ? nothing : found->second;
      const Places is = seen(*module, number);
      if (is == should) continue;
      for (const Place& one : should) {
        if (!is.contains(one)) text += module->client().name() + " misses " + wish.text + " of " + one + "\n";
      }
      for (const Place& one : is) {
        if (!should.contains(one)) text += module->client().name() + " has surplus " + wish.text + " of " + one + "\n";
      }
    }
  }
  return text;
}

bool Team::settle(base::Duration at_most) {
  const base::Instant end = world_.now() + at_most;
  while (!is_right()) {
    if (world_.now() >= end) {
      ADD_FAILURE() << "the views are not right. " << world_.when() << "\n" << complaints();
      return false;
    }
    world_.run_for(std::chrono::milliseconds(20));
  }
  return true;
}

void Team::check_views() {
  std::map<std::string, base::Instant> still_wrong;
  const std::string text = is_excused ? "" : complaints();
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const std::string one = text.substr(begin, end - begin);
    begin = end + 1;
    const auto known = wrong_since_.find(one);
    const base::Instant since = known == wrong_since_.end() ? world_.now() : known->second;
    const base::Duration bound = one.find(" misses ") != std::string::npos ? bounds_.missing : bounds_.surplus;
    EXPECT_LE(world_.now() - since, bound) << one << " for too long. " << world_.when();
    still_wrong[one] = since;
  }
  wrong_since_ = std::move(still_wrong);
}

void Team::check_identifiers() {
  std::map<std::string, const Host*> owners;
  bool is_unique = true;
  for (const auto& module : modules_) {
    const std::string& id = module->client().participant();
    if (!module->client().is_connected() || id.empty()) continue;
    const auto [owner, is_new] = owners.emplace(id, &module->host());
    is_unique &= is_new || owner->second == &module->host();
  }
  if (is_unique || is_excused) {
    same_identifier_since_ = base::never;
    return;
  }
  same_identifier_since_ = std::min(same_identifier_since_, world_.now());
  EXPECT_LE(world_.now() - same_identifier_since_, longest_clash) << "two have the same identifier. " << world_.when();
}

}  // namespace geminga::sim
