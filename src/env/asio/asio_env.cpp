#include "env/asio/asio_env.hpp"

#include <sys/random.h>

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "env/asio/families.hpp"

namespace geminga::env {
namespace {

namespace net = boost::asio;
using base::LogLevel;
using net::ip::address;

base::Instant to_instant(std::chrono::steady_clock::time_point time) {
  return base::Instant(std::chrono::duration_cast<base::Duration>(time.time_since_epoch()));
}

base::Instant read_clock() { return to_instant(std::chrono::steady_clock::now()); }

std::chrono::steady_clock::time_point to_steady(base::Instant instant) {
  return std::chrono::steady_clock::time_point(
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(instant.time_since_epoch()));
}

}  // namespace

AsioEnv::AsioEnv(net::io_context& context, base::LogSink& log)
    : context_(context), log_(log), timer_(context), now_(read_clock()), routes_(context, [this] {
        tell([](EventSink& sink) { sink.on_routes_changed(); });
      }) {
  streams_ = std::make_shared<Streams>(
      context,
      Streams::Handlers{
          .opened = [this](StreamId id,
                           const std::string& user) { tell([&](auto& sink) { sink.on_stream_opened(id, user); }); },
          .bytes = [this](StreamId id,
                          std::string_view bytes) { tell([&](auto& sink) { sink.on_stream_bytes(id, bytes); }); },
          .drained = [this](StreamId id) { tell([&](auto& sink) { sink.on_stream_drained(id); }); },
          .closed = [this](StreamId id) { tell([&](auto& sink) { sink.on_stream_closed(id); }); }});
}

AsioEnv::~AsioEnv() { streams_->shut_down(); }

void AsioEnv::begin_event() { now_ = read_clock(); }

void AsioEnv::event(const std::function<void()>& action) {
  begin_event();
  action();
  streams_->flush();
}

void AsioEnv::open_air(AirSettings settings) {
  settings_ = std::move(settings);
  groups_.clear();
  for (const std::string& group : settings_.groups) groups_.push_back(net::ip::make_address(group));
  links_.clear();
  problems_.clear();
  unicast_.reset();
  if (!settings_.peers.empty() || settings_.admission != Admission::nobody) {
    unicast_ = std::make_unique<Unicast>(
        context_,
        UnicastSettings{.peers = settings_.peers,
                        .are_links = settings_.are_peers_links,
                        .admission = settings_.admission,
                        .port = settings_.port},
        log_, air_counts_,
        [this](InterfaceIndex interface, const address& source, std::span<const std::byte> datagram) {
          receive(interface, source, datagram);
        });
  }
  const bool is_well = scan();
  watch_ = std::make_unique<LinkWatch>(context_, is_well, [this] { return scan(); });
}

void AsioEnv::serve(EventSink& sink) {
  sink_ = &sink;
  streams_->serve();
}

void AsioEnv::wake_at(base::Instant instant) {
  wanted_ = instant;
  if (wanted_ >= armed_) return;  // the timer comes earlier, and is then set again
  arm();
}

void AsioEnv::send(InterfaceIndex interface, std::span<const std::byte> datagram) {
  if (const auto found = links_.find(interface); found != links_.end()) {
    found->second->send(datagram);
    watch_sending(*found->second);
  }
  if (unicast_) unicast_->send(interface, datagram);
}

std::optional<base::Instant> AsioEnv::last_heard(InterfaceIndex interface) const {
  const auto found = links_.find(interface);
  if (found == links_.end()) return std::nullopt;
  return to_instant(found->second->last_heard());
}

void AsioEnv::send_alone(InterfaceIndex interface, std::string_view address, std::span<const std::byte> datagram) {
  if (unicast_) unicast_->send_alone(interface, address, datagram);
}

bool AsioEnv::is_sender_named() const { return unicast_ && unicast_->is_sender_named(); }
bool AsioEnv::is_sender_unnamed() const { return unicast_ && unicast_->is_sender_unnamed(); }
void AsioEnv::answer_sender(base::Duration time) {
  if (unicast_) unicast_->answer_sender(time);
}
UnicastCounts AsioEnv::unicast_counts() const { return unicast_ ? unicast_->counts() : UnicastCounts{}; }

void AsioEnv::arm() {
  armed_ = wanted_;
  if (armed_ == base::never) {
    timer_.cancel();
    return;
  }
  timer_.expires_at(to_steady(armed_));
  timer_.async_wait([this](const boost::system::error_code& error) {
    if (error || armed_ == base::never) return;
    if (read_clock() < armed_) return;  // an expiry that was on its way when the timer was set anew
    armed_ = base::never;
    if (read_clock() < wanted_) {
      arm();
      return;
    }
    wanted_ = base::never;
    tell([](EventSink& sink) { sink.on_timer(); });
  });
}

void AsioEnv::receive(InterfaceIndex interface, const address& source, std::span<const std::byte> datagram) {
  tell([&](EventSink& sink) { sink.on_datagram(interface, source.to_string(), datagram); });
}

bool AsioEnv::scan() {
  auto scan = scan_links(settings_.interfaces);
  if (!scan) {
    // Only the look has failed: the interfaces in use stay.
    if (scan_problem_ != scan.error()) {
      log_.write(LogLevel::warning, "cannot look at the network interfaces: " + scan.error() + ": trying each second");
    }
    scan_problem_ = scan.error();
    return false;
  }
  if (!std::exchange(scan_problem_, {}).empty()) {
    log_.write(LogLevel::info, "looking at the network interfaces works again");
  }
  say_ignored(std::move(scan->ignored));
  const std::vector<Link>& links = scan->links;
  const std::vector<Joined> found = by_family(links, groups_);
  bool is_changed =
      std::erase_if(links_, [&](const auto& entry) {
        return std::ranges::none_of(found, [&](const Joined& one) { return one.link.interface.index == entry.first; });
      }) > 0;
  for (const auto& [link, groups] : found) {
    const auto in_use = links_.find(link.interface.index);
    const bool was_open = in_use != links_.end();
    const bool was_sound = was_open && in_use->second->is_sound();
    if (was_sound && !in_use->second->is_short() && in_use->second->update(link)) continue;
    if (was_open) links_.erase(in_use);
    const bool is_sound = open(link, groups);
    is_changed = is_changed || !was_open || was_sound || is_sound;
  }
  if (unicast_) unicast_->set_links(links);
  std::vector<Interface> seen;
  for (const Joined& one : found) {
    seen.push_back(one.link.interface);
    seen.back().announced = announced_on(seen.back(), settings_.announced);
  }
  if (unicast_) {
    std::ranges::move(unicast_->peer_links(seen), std::back_inserter(seen));
    std::ranges::sort(seen, {}, &Interface::index);
  }
  say_missing(seen);
  bool is_well = missing_.empty();
  for (const auto& [index, link] : links_) {
    is_well = !link->take_failure() && link->is_sound() && !link->is_short() && is_well;
  }
  if (!is_changed && seen == interfaces_) return is_well;
  interfaces_ = std::move(seen);
  tell([](EventSink& sink) { sink.on_interfaces_changed(); });
  return is_well;
}

bool AsioEnv::open(const Link& link, const std::vector<address>& groups) {
  auto opened = std::make_unique<MulticastLink>(
      context_, link, groups, settings_.port, air_counts_,
      [this, index = link.interface.index](const address& source, std::span<const std::byte> datagram) {
        receive(index, source, datagram);
      });
  say_problems(*opened);
  const bool is_sound = opened->is_sound();
  links_.emplace(link.interface.index, std::move(opened));
  return is_sound;
}

void AsioEnv::say_problems(const MulticastLink& link) {
  const InterfaceIndex index = link.link().interface.index;
  const auto before = problems_.find(index);
  if (link.problems().empty()) {
    if (before == problems_.end()) return;
    problems_.erase(before);
    log_.write(LogLevel::info, "all is well on " + link.link().interface.name + " again");
    return;
  }
  if (before != problems_.end() && before->second == link.problems()) return;
  for (const std::string& problem : link.problems()) {
    log_.write(link.is_sound() ? LogLevel::debug : LogLevel::warning,
               problem + (link.is_sound() ? "" : ": trying each second"));
  }
  problems_[index] = link.problems();
}

void AsioEnv::say_ignored(std::vector<std::string> ignored) {
  if (ignored == ignored_) return;
  ignored_ = std::move(ignored);
  if (ignored_.empty()) return;
  log_.write(LogLevel::warning,
             "no room for more than " + std::to_string(max_links) +
                 " interfaces: name those that count with --interface; not used: " + base::joined(ignored_, ", "));
}

void AsioEnv::say_missing(const std::vector<Interface>& seen) {
  for (const std::string& name : settings_.interfaces) {
    const bool is_there = std::ranges::any_of(seen, [&](const Interface& interface) { return interface.name == name; });
    if (is_there) {
      missing_.erase(name);
    } else if (missing_.insert(name).second) {
      log_.write(LogLevel::warning, "interface " + name + " is not there or not up: waiting for it");
    }
  }
}

void AsioEnv::watch_sending(const MulticastLink& link) {
  int& last = send_errors_[link.link().interface.index];
  if (link.last_send_error() == last) return;
  last = link.last_send_error();
  const bool is_ipv6_side = link.link().interface.ipv6_side_of.has_value();
  const std::string name = link.link().interface.name + (is_ipv6_side ? " over IPv6" : "");
  if (last == 0) {
    log_.write(is_ipv6_side ? LogLevel::debug : LogLevel::info, "sending on " + name + " works again");
  } else {
    // An IPv6 side sends one datagram, perhaps while its address is still being tried (RFC 4862, 5.4), and then nothing
    // for long.
    log_.write(is_ipv6_side ? LogLevel::debug : LogLevel::warning,
               "cannot send on " + name + ": " + std::generic_category().message(last));
  }
}

std::expected<void, std::string> AsioEnv::listen(const Endpoint& endpoint, bool may_be_missing) {
  const auto listening = streams_->listen(endpoint);
  if (listening) return {};
  const ListenError& error = listening.error();
  if (error.cause == ListenError::Cause::in_use) {
    return std::unexpected(to_string(endpoint) + " is already in use: another gemingad? choose another with --gcnp");
  }
  if (error.cause == ListenError::Cause::not_available && may_be_missing) {
    log_.write(LogLevel::info, to_string(endpoint) + " is not available on this host: going on without it");
    return {};
  }
  return std::unexpected("cannot listen on " + to_string(endpoint) + ": " + error.text);
}

std::uint64_t AsioEnv::random_bits() {
  std::uint64_t bits = 0;
  // Up to 256 octets are never cut short or interrupted once the pool is ready (getrandom(2)); before that it blocks.
  while (::getrandom(&bits, sizeof bits, 0) != static_cast<ssize_t>(sizeof bits)) {
    GEMINGA_ASSERT(errno == EINTR);
  }
  return bits;
}

}  // namespace geminga::env
