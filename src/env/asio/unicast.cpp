#include "env/asio/unicast.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cerrno>
#include <map>
#include <optional>
#include <string>

#include "env/asio/event_sink.hpp"
#include "env/asio/multicast.hpp"

namespace geminga::env {
namespace {

namespace net = boost::asio;
using net::ip::address;
using net::ip::udp;

struct Peer {
  HostPort name;
  std::optional<udp::endpoint> endpoint;
  std::optional<address> via;  // our own address on the way there; nothing: no route through an interface in use
  std::string complaint;       // the last one, so that it is said once
};

/// Our own address on the kernel's route to the endpoint. Sends nothing.
std::optional<address> source_towards(net::io_context& context, const udp::endpoint& endpoint) {
  udp::socket probe(context);
  boost::system::error_code error;
  probe.open(endpoint.protocol(), error);
  if (!error) probe.connect(endpoint, error);
  if (error) return std::nullopt;
  const udp::endpoint local = probe.local_endpoint(error);
  if (error) return std::nullopt;
  if (local.address().is_v6()) return address(net::ip::address_v6(local.address().to_v6().to_bytes()));
  return local.address();
}

}  // namespace

class Unicast::State : public std::enable_shared_from_this<Unicast::State> {
 public:
  State(net::io_context& context, std::vector<HostPort> peers, std::uint16_t port, base::LogSink& log,
        AirCounts& counts, Receive receive)
      : context_(context),
        port_(port),
        log_(log),
        counts_(counts),
        receive_(std::move(receive)),
        resolver_(context),
        timer_(context) {
    for (HostPort& peer : peers) peers_.push_back({std::move(peer), std::nullopt, std::nullopt, {}});
  }

  void start() {
    for (Peer& peer : peers_) {
      boost::system::error_code error;
      const address numeric = net::ip::make_address(peer.name.host, error);
      if (!error) peer.endpoint = udp::endpoint(numeric, peer.name.port);
    }
    resolve_names();
  }

  void stop() {
    is_stopped_ = true;
    resolver_.cancel();
    timer_.cancel();
    sockets_.clear();
  }

  void set_links(const std::vector<Link>& links) {
    links_ = links;
    std::map<address, InterfaceIndex> wanted;
    for (const Link& link : links) {
      for (const Prefix& prefix : link.prefixes) {
        // A link-local peer would need a scope in --peer; such hosts are on link and reached by multicast.
        if (prefix.address.is_v6() && prefix.address.to_v6().is_link_local()) continue;
        wanted.emplace(prefix.address, link.interface.index);
      }
    }
    std::erase_if(sockets_, [&](const auto& entry) {
      const auto found = wanted.find(entry.first);
      return found == wanted.end() || found->second != entry.second->interface;
    });
    for (const auto& [own, interface] : wanted) {
      if (!sockets_.contains(own)) open(own, interface);
    }
    find_routes();
  }

  void send(InterfaceIndex interface, std::span<const std::byte> datagram) {
    for (const Peer& peer : peers_) {
      if (!peer.endpoint || !peer.via) continue;
      const auto found = sockets_.find(*peer.via);
      if (found == sockets_.end() || found->second->interface != interface) continue;
      (void)::sendto(found->second->socket.native_handle(), datagram.data(), datagram.size(),
                     MSG_DONTWAIT | MSG_NOSIGNAL, peer.endpoint->data(), static_cast<socklen_t>(peer.endpoint->size()));
    }
  }

 private:
  struct Socket {
    udp::socket socket;
    InterfaceIndex interface;
    Receiver receiver;
  };

  void say(base::LogLevel level, std::string& last, std::string text) {
    if (last == text) return;
    if (!text.empty()) log_.write(level, text);
    last = std::move(text);
  }

  void open(const address& own, InterfaceIndex interface) {
    auto socket = std::make_shared<Socket>(udp::socket(context_), interface, Receiver());
    boost::system::error_code error;
    socket->socket.open(own.is_v4() ? udp::v4() : udp::v6(), error);
    if (!error && own.is_v6()) socket->socket.set_option(net::ip::v6_only(true), error);
    if (!error && !Receiver::watch_interface(socket->socket, own.is_v4()))
      error.assign(errno, boost::system::generic_category());
    if (!error) socket->socket.bind({own, port_}, error);
    if (error) {
      say(base::LogLevel::warning, complaints_[own],
          "cannot listen to peers on " + to_string(Endpoint{own.to_string(), port_}) + ": " + error.message() +
              (error == net::error::address_in_use ? ": another gemingad? give one of them another --port" : ""));
      return;
    }
    socket->receiver.watch_drops(socket->socket);
    complaints_.erase(own);
    sockets_.emplace(own, socket);
    await(socket);
  }

  void await(const std::shared_ptr<Socket>& socket) {
    socket->socket.async_wait(udp::socket::wait_read,
                              [self = shared_from_this(), socket](const boost::system::error_code& error) {
                                if (error || self->is_stopped_) return;
                                self->drain(*socket);
                                if (socket->socket.is_open()) self->await(socket);
                              });
  }

  void drain(Socket& socket) {
    std::array<std::byte, max_datagram_bytes + 1> buffer;
    for (int turn = 0; turn < max_datagrams_per_turn && !is_stopped_; ++turn) {
      const auto reception = socket.receiver.receive(socket.socket, buffer, counts_);
      if (!reception && errno == ECONNREFUSED) continue;  // a peer that is not there yet
      if (!reception) return;
      const address from = reception->from.address();
      const auto peer = std::ranges::find_if(
          peers_, [&](const Peer& each) { return each.endpoint && each.endpoint->address() == from; });
      if (peer == peers_.end()) {
        ++counts_.no_peer;
      } else if (!can_come_in(*peer, InterfaceIndex{reception->interface})) {
        ++counts_.wrong_way;
      } else {
        receive_(socket.interface, from, std::span(buffer).first(reception->size));
      }
    }
  }

  /// Whether what this peer sends can come in on that interface.
  [[nodiscard]] bool can_come_in(const Peer& peer, InterfaceIndex interface) const {
    const address& from = peer.endpoint->address();
    // Another daemon of this host: the kernel lets nothing in from outside that has an address of ours as its source.
    if (sockets_.contains(from)) return true;
    const auto way = peer.via ? sockets_.find(*peer.via) : sockets_.end();
    if (way != sockets_.end() && way->second->interface == interface) return true;
    return std::ranges::any_of(
        links_, [&](const Link& link) { return link.interface.index == interface && link.has_network_of(from); });
  }

  void find_routes() {
    for (Peer& peer : peers_) {
      peer.via.reset();
      if (!peer.endpoint) continue;
      const auto source = source_towards(context_, *peer.endpoint);
      const bool is_self = source == peer.endpoint->address() && peer.endpoint->port() == port_;
      if (source && !is_self && sockets_.contains(*source)) peer.via = source;
      const bool is_mute = !peer.via && !is_self;
      say(base::LogLevel::warning, peer.complaint,
          is_mute ? "peer " + to_string(peer.name) + ": no route through an interface in use" : "");
    }
  }

  /// Resolves one name after the other, then waits. Names alone cost a thread (of the resolver).
  void resolve_names(std::size_t number = 0) {
    const auto is_name = [](const Peer& peer) {
      boost::system::error_code error;
      net::ip::make_address(peer.name.host, error);
      return static_cast<bool>(error);
    };
    while (number < peers_.size() && !is_name(peers_[number])) ++number;
    if (number == peers_.size()) return wait_and_resolve();
    resolver_.async_resolve(peers_[number].name.host, "", net::ip::resolver_base::flags{},
                            [self = shared_from_this(), number](const boost::system::error_code& error,
                                                                const udp::resolver::results_type& results) {
                              if (self->is_stopped_) return;
                              self->take(self->peers_[number], error, results);
                              self->resolve_names(number + 1);
                            });
    has_names_ = true;
  }

  void wait_and_resolve() {
    if (!has_names_) return;
    const bool is_complete = std::ranges::all_of(peers_, [](const Peer& peer) { return peer.endpoint.has_value(); });
    timer_.expires_after(is_complete ? resolve_refresh : resolve_retry);
    timer_.async_wait([self = shared_from_this()](const boost::system::error_code& error) {
      if (!error && !self->is_stopped_) self->resolve_names();
    });
  }

  /// Takes the first IPv4 address, else the first; a name that resolves no more keeps its last address.
  void take(Peer& peer, const boost::system::error_code& error, const udp::resolver::results_type& results) {
    if (error || results.empty()) {
      say(base::LogLevel::warning, peer.complaint,
          "peer " + to_string(peer.name) + " cannot be resolved: " + error.message() + ": will try again");
      return;
    }
    peer.complaint.clear();
    udp::endpoint chosen = results.begin()->endpoint();
    for (const auto& result : results) {
      if (!result.endpoint().address().is_v4()) continue;
      chosen = result.endpoint();
      break;
    }
    chosen.port(peer.name.port);
    peer.endpoint = chosen;
    find_routes();
  }

  net::io_context& context_;
  std::uint16_t port_;
  base::LogSink& log_;
  AirCounts& counts_;
  Receive receive_;
  udp::resolver resolver_;
  net::steady_timer timer_;
  std::vector<Peer> peers_;
  std::vector<Link> links_;
  std::map<address, std::shared_ptr<Socket>> sockets_;  // by our own address
  std::map<address, std::string> complaints_;
  bool has_names_ = false;
  bool is_stopped_ = false;
};

Unicast::Unicast(net::io_context& context, std::vector<HostPort> peers, std::uint16_t port, base::LogSink& log,
                 AirCounts& counts, Receive receive)
    : state_(std::make_shared<State>(context, std::move(peers), port, log, counts, std::move(receive))) {
  state_->start();
}
Unicast::~Unicast() { state_->stop(); }
void Unicast::set_links(const std::vector<Link>& links) { state_->set_links(links); }
void Unicast::send(InterfaceIndex interface, std::span<const std::byte> datagram) { state_->send(interface, datagram); }

}  // namespace geminga::env
