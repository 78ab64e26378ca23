// One host of the simulated world: the Env of a participant that can be switched on, crashed and switched on again.
#ifndef GEMINGA_TESTS_SIM_HOST_HPP
#define GEMINGA_TESTS_SIM_HOST_HPP

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "discovery/participant/participant.hpp"
#include "env/env.hpp"
#include "sim/client.hpp"
#include "sim/clock.hpp"
#include "sim/connections.hpp"
#include "sim/world.hpp"

namespace geminga::sim {

/// Its clock runs from another zero than everybody else's, as monotonic clocks do.
class Host final : public env::Env {
 public:
  /// One interface: on which network it is, and under which address.
  struct Port {
    env::InterfaceIndex index{};
    std::uint32_t segment = 0;
    std::string address;
  };

  Host(World& world, std::string name, std::uint32_t number, std::uint64_t seed);
  ~Host() override;

  /// Settings of the next participant that is switched on; its name is the host's until changed.
  participant::Settings settings;
  vocabulary::Vocabulary ontology;
  /// How long it takes to prepare an ontology for class expressions; 0: it is there within the event that asks for it.
  base::Duration preparing_takes{};
  /// The lines of its log.
  std::vector<std::string> logged;
  /// Whether all that it hears came to it alone, from hosts that it has not named.
  bool hears_strangers_alone = false;
  /// Whether multicasts of others reach it.
  bool hears_multicasts = true;
  /// The names of hosts whose multicasts do not reach it.
  std::set<std::string> multicasts_kept_from;
  /// Whether datagrams to it alone reach it. Hosts that it wishes to answer are sent copies then.
  bool hears_datagrams_alone = false;
  /// Whether they come from hosts that are named by --peer.
  bool names_others = false;
  /// Octets that it has sent to others alone.
  std::uint64_t octets_sent_alone = 0;
  /// For how long it wished to answer each of these that it wished to answer.
  std::vector<base::Duration> answered;
  /// The identifiers that random_bits() gives first, to bring about a clash.
  std::vector<std::uint64_t> forced_bits;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] World& world() { return world_; }
  [[nodiscard]] std::uint32_t number() const { return number_; }

  /// Constructs and starts a participant. One that sleeps wakes up first.
  void switch_on();
  /// The host vanishes: nothing is said, clients see their connections end.
  void crash();
  /// The participant is asked to stop, and is destroyed when it has.
  void stop();
  [[nodiscard]] bool is_on() const { return participant_ != nullptr; }
  /// Whether its participant ended without a goodbye when it was last on.
  [[nodiscard]] bool has_crashed() const { return has_crashed_; }

  /// How a host does nothing for a while, and keeps what it knows.
  enum class Pause : std::uint8_t {
    none,
    stopped,  ///< the process has no processor: its clock goes on, and datagrams wait for it, as many as a socket holds
    asleep,   ///< the computer sleeps: its clock stands still, and nothing waits for it
  };
  void pause(Pause how);
  void resume();
  [[nodiscard]] Pause pause() const { return pause_; }
  /// Whether it has just gone on after a pause, and reads what was said meanwhile.
  [[nodiscard]] bool is_catching_up() const;
  /// Its clock gains or loses so many millionths from now on.
  void set_drift(std::int64_t millionths);
  /// The host's one timer; called by the world.
  void ring();
  [[nodiscard]] const participant::Participant& participant() const { return *participant_; }
  /// Lets something happen to the participant; what it says about it goes on its way at the end.
  void event(const std::function<void(participant::Participant&)>& what);
  /// Reads another ontology while the participant runs, as gemingad does: where expressions are in use it comes into
  /// force when it is prepared for them.
  void reload(const vocabulary::Vocabulary& another);
  /// Counts how often it was switched on or off, so that what was meant for an earlier incarnation does not reach a
  /// later one.
  [[nodiscard]] std::uint64_t incarnation() const { return incarnation_; }

  /// A port that nobody else on this host has been given.
  [[nodiscard]] std::uint16_t take_port() { return next_port_++; }

  void attach(const std::string& interface, std::uint32_t segment, bool is_loopback = false);
  /// The answers of Env::route() from now on.
  using Routes = std::function<env::RouteKind(std::string_view address)>;
  void set_routes(Routes routes);
  /// The address by which others hear it, as behind a translation of addresses; empty: its own.
  std::string seen_as;
  /// The interface speaks IPv6, too, which another network carries; one that is not there speaks nothing else.
  void attach_ipv6(const std::string& interface, std::uint32_t segment);
  void detach(const std::string& interface);
  [[nodiscard]] const std::vector<Port>& ports() const { return ports_; }
  [[nodiscard]] const Port* port(env::InterfaceIndex index) const;
  void receive(env::InterfaceIndex interface, const std::string& source, std::string_view datagram,
               bool is_alone = false);
  /// Hosts hear each other only where their island is the same number.
  void set_island(int island);
  [[nodiscard]] int island() const { return island_; }

  /// Connects a client to the participant that is running; the client may outlive it.
  void connect(Client& client);
  [[nodiscard]] Connections& connections() { return connections_; }
  /// The datagrams and octets that it has sent since it was made.
  [[nodiscard]] std::uint64_t datagrams_sent() const { return datagrams_sent_; }
  [[nodiscard]] std::uint64_t octets_sent() const { return octets_sent_; }
  /// The datagrams among them that went out over this network.
  [[nodiscard]] std::uint64_t datagrams_sent_on(std::uint32_t segment) const;

  [[nodiscard]] base::Instant now() const override;
  void wake_at(base::Instant instant) override;
  [[nodiscard]] std::uint64_t random_bits() override;
  [[nodiscard]] const std::vector<env::Interface>& interfaces() const override { return interfaces_; }
  void send(env::InterfaceIndex interface, std::span<const std::byte> datagram) override;
  void send_alone(env::InterfaceIndex interface, std::string_view address,
                  std::span<const std::byte> datagram) override;
  [[nodiscard]] env::RouteKind route(std::string_view address) override {
    return routes_ ? routes_(address) : env::RouteKind::unknown;
  }
  [[nodiscard]] bool is_sender_named() const override { return alone_from_ && names_others; }
  [[nodiscard]] bool is_sender_unnamed() const override {
    return hears_strangers_alone || (alone_from_ && !names_others);
  }
  void answer_sender(base::Duration time) override;
  void write(env::StreamId stream, std::string_view bytes) override { connections_.write(stream, bytes); }
  [[nodiscard]] std::size_t unsent(env::StreamId stream) const override { return connections_.unsent(stream); }
  void want(env::StreamId stream, bool is_wanted) override { connections_.want(stream, is_wanted); }
  void close(env::StreamId stream) override { connections_.close(stream); }
  [[nodiscard]] base::LogSink& log() override;

 private:
  class Log;

  void end_of_event();
  void arm();
  void prepare();
  void prepare_for(std::function<void()> then);

  World& world_;
  std::string name_;
  std::uint32_t number_;
  base::Random random_;
  Clock clock_;
  std::unique_ptr<Log> log_;
  std::unique_ptr<participant::Participant> participant_;
  bool is_stopping_ = false;
  bool has_crashed_ = false;
  std::uint64_t incarnation_ = 0;
  base::Instant wake_ = base::never;   ///< when the participant wants to be woken, by its own clock
  base::Instant armed_ = base::never;  ///< when the world rings next, or earlier than that
  Pause pause_ = Pause::none;
  base::Instant resumed_{-std::chrono::hours(1)};
  /// A datagram that came in while the process was stopped.
  struct Waiting {
    env::InterfaceIndex interface{};
    std::string source;
    std::string datagram;
    bool is_alone = false;
  };
  std::vector<Waiting> waiting_;
  /// The way of the sender of the datagram of this event, where it came alone.
  std::optional<std::pair<env::InterfaceIndex, std::string>> alone_from_;
  /// The hosts that are sent copies, and until when.
  std::map<std::pair<env::InterfaceIndex, std::string>, base::Instant> guests_;
  std::uint64_t datagrams_sent_ = 0;
  std::uint64_t octets_sent_ = 0;
  std::map<std::uint32_t, std::uint64_t> sent_on_;
  std::uint16_t next_port_ = 5000;
  std::uint32_t next_interface_ = 2;
  int island_ = 0;
  Routes routes_;  ///< empty: it does not tell
  std::vector<Port> ports_;
  std::vector<env::Interface> interfaces_;
  Connections connections_{*this};
  std::uint64_t preparing_ = 0;  ///< counts, so that one that is given up brings nothing
  bool is_preparing_ = false;
};

}  // namespace geminga::sim

#endif
