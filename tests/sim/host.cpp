#include "sim/host.hpp"

#include <algorithm>
#include <utility>

namespace geminga::sim {
namespace {

/// Datagrams that a socket of the usual 208 KiB holds, each with what the kernel keeps beside it.
constexpr std::size_t socket_room = 256;
constexpr base::Duration time_to_catch_up = std::chrono::milliseconds(500);

}  // namespace

/// Enters the daemon's words into the trace: they must not depend on chance either.
class Host::Log final : public base::LogSink {
 public:
  Log(World& world, const std::string& who, std::vector<std::string>& lines)
      : world_(world), who_(who), lines_(lines) {}
  void write(base::LogLevel, std::string_view line, const base::LogFields&) override {
    world_.trace(who_, line);
    lines_.emplace_back(line);
  }

 private:
  World& world_;
  const std::string& who_;
  std::vector<std::string>& lines_;
};

Host::Host(World& world, std::string name, std::uint32_t number, std::uint64_t seed)
    : world_(world),
      name_(std::move(name)),
      number_(number),
      random_(seed),
      clock_(random_.between(std::chrono::seconds(1), std::chrono::hours(1000))),
      log_(std::make_unique<Log>(world_, name_, logged)) {
  settings.name = name_;
  settings.shared = world_.shared;
  settings.shared_entries = world_.shared_entries;
}

Host::~Host() = default;

void Host::switch_on() {
  ++incarnation_;
  is_stopping_ = false;
  is_preparing_ = false;
  has_crashed_ = false;
  resume();
  world_.trace(name_, "on");
  participant_ = std::make_unique<participant::Participant>(*this, settings, ontology);
  participant_->start();
  end_of_event();
}

void Host::crash() {
  if (!is_on()) return;
  ++incarnation_;
  has_crashed_ = true;
  wake_ = base::never;
  world_.trace(name_, "crash");
  participant_.reset();
  connections_.drop();
}

void Host::pause(Pause how) {
  if (!is_on() || pause_ != Pause::none || how == Pause::none) return;
  world_.trace(name_, "pause");
  pause_ = how;
  if (how == Pause::asleep) clock_.stop(world_.now());
  if (world_.on_reach_changed) world_.on_reach_changed();
}

void Host::resume() {
  if (pause_ == Pause::none) return;
  world_.trace(name_, "resume");
  if (pause_ == Pause::asleep) clock_.go_on(world_.now());
  pause_ = Pause::none;
  resumed_ = world_.now();
  if (!waiting_.empty()) world_.old_words_read = resumed_;
  for (const Waiting& one : std::exchange(waiting_, {})) receive(one.interface, one.source, one.datagram, one.is_alone);
  connections_.resume();
  armed_ = base::never;
  arm();
  if (world_.on_reach_changed) world_.on_reach_changed();
}

bool Host::is_catching_up() const { return world_.now() - resumed_ < time_to_catch_up; }

void Host::set_drift(std::int64_t millionths) {
  clock_.set_drift(world_.now(), millionths);
  armed_ = base::never;
  arm();
}

void Host::set_island(int island) {
  island_ = island;
  if (world_.on_reach_changed) world_.on_reach_changed();
}

void Host::stop() {
  if (!is_on()) return;
  world_.trace(name_, "stop");
  is_stopping_ = true;
  participant_->stop();
  end_of_event();
}

void Host::prepare_for(std::function<void()> then) {
  is_preparing_ = true;
  const std::uint64_t number = ++preparing_;
  const auto done = [this, number, then = std::move(then), incarnation = incarnation_] {
    if (incarnation != incarnation_ || number != preparing_) return;
    is_preparing_ = false;
    then();
    end_of_event();
  };
  if (preparing_takes == base::Duration(0)) return done();
  world_.after(preparing_takes, done);
}

void Host::prepare() {
  const vocabulary::Vocabulary* wanted = participant_->wants_prepared();
  if (wanted == nullptr || is_preparing_) return;
  prepare_for([this, asked = *wanted] { participant_->on_prepared(asked.with_expressions()); });
}

void Host::reload(const vocabulary::Vocabulary& another) {
  ontology = another;
  ++preparing_;
  is_preparing_ = false;
  if (!another.is_loaded() || !participant_->uses_expressions()) {
    return event([&](participant::Participant& participant) { participant.set_vocabulary(another); });
  }
  prepare_for([this, another] { participant_->set_vocabulary(another.with_expressions()); });
}

void Host::end_of_event() {
  connections_.flush();
  arm();
  if (participant_ != nullptr) prepare();
  if (!is_stopping_ || participant_ == nullptr || !participant_->is_stopped()) return;
  ++incarnation_;
  wake_ = base::never;
  participant_.reset();
  connections_.drop();
}

void Host::attach(const std::string& interface, std::uint32_t segment, bool is_loopback) {
  const auto index = env::InterfaceIndex(is_loopback ? 1 : next_interface_++);
  const std::string tail = std::to_string(number_);
  const std::string ipv4 = is_loopback ? "127.0.0.1"
                                       : "10." + std::to_string(number_ / 256) + "." + std::to_string(segment) + "." +
                                             std::to_string(number_ % 256);
  ports_.push_back(Port{.index = index, .segment = segment, .address = ipv4});
  interfaces_.push_back(env::Interface{.index = index,
                                       .name = interface,
                                       .addresses = {ipv4, is_loopback ? "::1" : "fe80::" + tail},
                                       .is_loopback = is_loopback});
  std::ranges::sort(interfaces_, {}, &env::Interface::index);
  event([](participant::Participant& participant) { participant.on_interfaces_changed(); });
}

void Host::attach_ipv6(const std::string& interface, std::uint32_t segment) {
  const auto other = std::ranges::find(interfaces_, interface, &env::Interface::name);
  env::Interface added{.index = env::InterfaceIndex(next_interface_++),
                       .name = interface,
                       .addresses = {"fe80::" + std::to_string(number_)}};
  if (other != interfaces_.end()) added.ipv6_side_of = other->index;
  ports_.push_back(Port{.index = added.index, .segment = segment, .address = added.addresses.front()});
  interfaces_.push_back(std::move(added));
  event([](participant::Participant& participant) { participant.on_interfaces_changed(); });
}

void Host::detach(const std::string& interface) {
  if (std::ranges::find(interfaces_, interface, &env::Interface::name) == interfaces_.end()) return;
  std::erase_if(interfaces_, [&](const env::Interface& one) { return one.name == interface; });
  std::erase_if(ports_, [&](const Port& port) {
    return std::ranges::find(interfaces_, port.index, &env::Interface::index) == interfaces_.end();
  });
  event([](participant::Participant& participant) { participant.on_interfaces_changed(); });
}

void Host::set_routes(Routes routes) {
  routes_ = std::move(routes);
  event([](participant::Participant& participant) { participant.on_routes_changed(); });
}

void Host::event(const std::function<void(participant::Participant&)>& what) {
  if (!is_on()) return;
  what(*participant_);
  end_of_event();
}

const Host::Port* Host::port(env::InterfaceIndex index) const {
  const auto found = std::ranges::find(ports_, index, &Port::index);
  return found == ports_.end() ? nullptr : &*found;
}

void Host::receive(env::InterfaceIndex interface, const std::string& source, std::string_view datagram, bool is_alone) {
  if (!is_on() || port(interface) == nullptr || pause_ == Pause::asleep) return;
  if (pause_ == Pause::stopped) {
    if (waiting_.size() < socket_room) waiting_.emplace_back(interface, source, std::string(datagram), is_alone);
    return;
  }
  if (is_alone) alone_from_ = {interface, source};
  participant_->on_datagram(interface, source, std::as_bytes(std::span(datagram)));
  alone_from_.reset();
  end_of_event();
}

void Host::connect(Client& client) {
  const auto stream = connections_.next();
  client.connected(*this, stream);
  if (!is_on()) {
    client.connection_lost();
    return;
  }
  connections_.open(stream, client);
  participant_->on_stream_opened(stream, client.user);
  end_of_event();
}

base::Instant Host::now() const { return clock_.local(world_.now()); }

void Host::wake_at(base::Instant instant) { wake_ = instant; }

/// The world is asked to ring only where it would not do so early enough. Most datagrams move the timer to a later
/// time, which is found out when it rings.
void Host::arm() {
  if (wake_ == base::never || pause_ != Pause::none) return;
  const base::Instant wanted = std::max(clock_.world(wake_), world_.now());
  if (wanted >= armed_) return;
  armed_ = wanted;
  world_.ring_at(armed_, *this);
}

void Host::ring() {
  if (world_.now() != armed_) return;  // asked for before an earlier one was
  armed_ = base::never;
  if (!is_on() || pause_ != Pause::none || wake_ == base::never) return;
  if (clock_.local(world_.now()) < wake_) return arm();
  participant_->on_timer();
  end_of_event();
}

std::uint64_t Host::random_bits() {
  if (forced_bits.empty()) return random_.next();
  const std::uint64_t bits = forced_bits.front();
  forced_bits.erase(forced_bits.begin());
  return bits;
}

void Host::send(env::InterfaceIndex interface, std::span<const std::byte> datagram) {
  ++datagrams_sent_;
  octets_sent_ += datagram.size();
  if (const Port* on = port(interface)) ++sent_on_[on->segment];
  world_.transmit(*this, interface, std::string_view(reinterpret_cast<const char*>(datagram.data()), datagram.size()));
  for (const auto& [way, until] : guests_) {
    if (way.first == interface && until > now()) send_alone(interface, way.second, datagram);
  }
}

void Host::send_alone(env::InterfaceIndex interface, std::string_view address, std::span<const std::byte> datagram) {
  octets_sent_alone += datagram.size();
  world_.transmit_alone(*this, interface, address,
                        std::string_view(reinterpret_cast<const char*>(datagram.data()), datagram.size()));
}

void Host::answer_sender(base::Duration time) {
  if (is_sender_unnamed()) answered.push_back(time);
  if (alone_from_ && time > base::Duration(0)) guests_[*alone_from_] = now() + time;
}

std::uint64_t Host::datagrams_sent_on(std::uint32_t segment) const {
  const auto found = sent_on_.find(segment);
  return found == sent_on_.end() ? 0 : found->second;
}

base::LogSink& Host::log() { return *log_; }

}  // namespace geminga::sim
