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
#include "env/asio/guests.hpp"
#include "env/asio/multicast.hpp"
#include "env/asio/named_peer.hpp"

namespace geminga::env {
namespace {

namespace net = boost::asio;
using net::ip::address;
using net::ip::udp;

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

class Unicast::Sockets : public std::enable_shared_from_this<Unicast::Sockets> {
 public:
  Sockets(net::io_context& context, UnicastSettings settings, base::LogSink& log, AirCounts& counts, Receive receive)
      : context_(context),
        port_(settings.port),
        are_links_(settings.are_links),
        admission_(settings.admission),
        log_(log),
        counts_(counts),
        receive_(std::move(receive)),
        resolver_(context),
        timer_(context),
        guests_(admission_ == Admission::asked ? max_guests : max_unasked_guests) {
    for (HostPort& peer : settings.peers) peers_.emplace_back(std::move(peer), Clock::now());
  }

  void start() { resolve_names(); }

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
        // A link-local peer would need a scope in --peer. Such hosts are on link, and multicast reaches them.
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
    for (std::size_t i = 0; i < peers_.size(); ++i) {
      const Route* route = peers_[i].route();
      if (route == nullptr) continue;
      if (!are_links_) {
        send(interface, *route, datagram);
      } else if (link_of(i) == interface) {
        send(*route, datagram);
      }
    }
    for (const Route& route : guests_.take_routes(datagram.size(), interface, Clock::now())) {
      send(interface, route, datagram);
    }
  }

  void send_alone(InterfaceIndex interface, std::string_view to, std::span<const std::byte> datagram) {
    boost::system::error_code error;
    const address host = net::ip::make_address(std::string(to), error);
    if (error) return;
    const udp::endpoint there(host, port_);
    send(interface, {there, source_towards(context_, there)}, datagram);
  }

  [[nodiscard]] std::vector<Interface> peer_links(const std::vector<Interface>& interfaces) const {
    std::vector<Interface> links;
    if (!are_links_) return links;
    for (std::size_t i = 0; i < peers_.size(); ++i) {
      const Route* route = peers_[i].route();
      const auto way = route != nullptr && route->via ? sockets_.find(*route->via) : sockets_.end();
      if (way == sockets_.end()) continue;
      const auto through = std::ranges::find(interfaces, way->second->interface, &Interface::index);
      if (through == interfaces.end()) continue;
      links.push_back(*through);
      links.back().index = link_of(i);
      links.back().name += ">" + to_string(peers_[i].name());
      links.back().is_named_peer = true;
    }
    return links;
  }

  [[nodiscard]] bool is_sender_named() const { return is_named_speaking_; }
  [[nodiscard]] bool is_sender_unnamed() const { return speaking_.has_value(); }
  void answer_sender(base::Duration time) {
    if (time == base::Duration(0) && admission_ != Admission::asked) return;
    if (speaking_) guests_.answer(*speaking_, time, Clock::now());
  }

  [[nodiscard]] UnicastCounts counts() const {
    UnicastCounts counts{.named = peers_.size(), .silent = 0, .guests = guests_.count(Clock::now())};
    for (const NamedPeer& peer : peers_) {
      if (!peer.is_ourselves() && !peer.was_heard_since(Clock::now() - peer_silence)) ++counts.silent;
    }
    return counts;
  }

 private:
  struct Socket {
    udp::socket socket;
    address own;
    InterfaceIndex interface;
    Receiver receiver;
  };

  void say(base::LogLevel level, std::string& last, std::string text) {
    if (last == text) return;
    if (!text.empty()) log_.write(level, text);
    last = std::move(text);
  }

  void open(const address& own, InterfaceIndex interface) {
    auto socket = std::make_shared<Socket>(udp::socket(context_), own, interface, Receiver());
    boost::system::error_code error;
    socket->socket.open(own.is_v4() ? udp::v4() : udp::v6(), error);
    if (!error && own.is_v6()) socket->socket.set_option(net::ip::v6_only(true), error);
    if (!error && !Receiver::watch_interface(socket->socket, own.is_v4()))
      error.assign(errno, boost::system::generic_category());
    if (!error) socket->socket.bind({own, port_}, error);
    if (error) {
      // Where nobody asked for it, as with two sealed daemons on one host, it is no matter.
      const bool is_wished = !peers_.empty() || admission_ != Admission::sealed;
      say(is_wished ? base::LogLevel::warning : base::LogLevel::debug, complaints_[own],
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

  /// A named host as a link of its own, by its place among them.
  static InterfaceIndex link_of(std::size_t peer) {
    return InterfaceIndex{first_peer_link + static_cast<std::uint32_t>(peer)};
  }

  void send(InterfaceIndex interface, const Route& route, std::span<const std::byte> datagram) {
    if (!route.via) return;
    const auto found = sockets_.find(*route.via);
    if (found != sockets_.end() && found->second->interface == interface) send(route, datagram);
  }

  void send(const Route& route, std::span<const std::byte> datagram) {
    const auto found = route.via ? sockets_.find(*route.via) : sockets_.end();
    if (found == sockets_.end()) return;
    (void)::sendto(found->second->socket.native_handle(), datagram.data(), datagram.size(), MSG_DONTWAIT | MSG_NOSIGNAL,
                   route.to.data(), static_cast<socklen_t>(route.to.size()));
  }

  void drain(Socket& socket) {
    std::array<std::byte, max_datagram_bytes + 1> buffer;
    for (int turn = 0; turn < max_datagrams_per_turn && !is_stopped_; ++turn) {
      const auto reception = socket.receiver.receive(socket.socket, buffer, counts_);
      if (!reception && errno == ECONNREFUSED) continue;  // a peer that is not there yet
      if (!reception) return;
      const address from = reception->from.address();
      const auto peer = speaker(reception->from);
      const bool is_named = peer != peers_.end() && can_come_in(*peer, from, InterfaceIndex{reception->interface});
      if (is_named) {
        peer->heard_from(from, Clock::now());
      } else if (admission_ == Admission::nobody) {
        ++(peer == peers_.end() ? counts_.no_peer : counts_.wrong_way);
        continue;
      } else {
        speaking_ = Guests::Sender{
            .to = reception->from, .via = socket.own, .interface = socket.interface, .octets = reception->size};
      }
      is_named_speaking_ = is_named;
      const bool is_link = is_named && are_links_;
      const auto place = static_cast<std::size_t>(peer - peers_.begin());
      receive_(is_link ? link_of(place) : socket.interface, from, std::span(buffer).first(reception->size));
      is_named_speaking_ = false;
      speaking_.reset();
    }
  }

  /// The named peer that speaks from there. Several may be at one address, as two bridges of this host are: then the
  /// port tells them apart, which a translation of addresses may have changed otherwise.
  std::vector<NamedPeer>::iterator speaker(const udp::endpoint& from) {
    const auto is_there = [&](const NamedPeer& each) { return each.is_at(from.address()); };
    const auto exact = std::ranges::find_if(
        peers_, [&](const NamedPeer& each) { return is_there(each) && each.name().port == from.port(); });
    return exact != peers_.end() ? exact : std::ranges::find_if(peers_, is_there);
  }

  /// Whether a datagram of this peer from one of its addresses can come in on that interface.
  [[nodiscard]] bool can_come_in(const NamedPeer& peer, const address& from, InterfaceIndex interface) const {
    // Another daemon of this host: the kernel lets no datagram in from outside whose source is an address of ours.
    if (sockets_.contains(from)) return true;
    const auto via = peer.via(from);
    const auto way = via ? sockets_.find(*via) : sockets_.end();
    if (way != sockets_.end() && way->second->interface == interface) return true;
    return std::ranges::any_of(
        links_, [&](const Link& link) { return link.interface.index == interface && link.has_network_of(from); });
  }

  void find_routes() {
    for (NamedPeer& peer : peers_) {
      peer.find_routes(port_, [&](const udp::endpoint& to) -> std::optional<address> {
        const auto source = source_towards(context_, to);
        return source && sockets_.contains(*source) ? source : std::nullopt;
      });
      const bool is_mute = peer.is_resolved() && !peer.is_ourselves() && !(peer.route() && peer.route()->via);
      if (!peer.is_resolved()) continue;
      say(base::LogLevel::warning, peer.complaint,
          is_mute ? "peer " + to_string(peer.name()) + ": no route through an interface in use" : "");
    }
  }

  /// Resolves the names that are due, one after the other, then waits. Only names cost a thread (of the resolver).
  void resolve_names(std::size_t number = 0) {
    while (number < peers_.size() && !peers_[number].is_due(Clock::now())) ++number;
    if (number == peers_.size()) return wait_and_resolve();
    resolver_.async_resolve(peers_[number].name().host, "", net::ip::resolver_base::flags{},
                            [self = shared_from_this(), number](const boost::system::error_code& error,
                                                                const udp::resolver::results_type& results) {
                              if (self->is_stopped_) return;
                              self->take(self->peers_[number], error, results);
                              self->resolve_names(number + 1);
                            });
  }

  void wait_and_resolve() {
    if (std::ranges::none_of(peers_, &NamedPeer::is_by_name)) return;
    timer_.expires_after(resolve_retry);
    timer_.async_wait([self = shared_from_this()](const boost::system::error_code& error) {
      if (!error && !self->is_stopped_) self->resolve_names();
    });
  }

  void take(NamedPeer& peer, const boost::system::error_code& error, const udp::resolver::results_type& results) {
    std::vector<address> found;
    if (!error)
      std::ranges::transform(results, std::back_inserter(found),
                             [](const auto& one) { return one.endpoint().address(); });
    peer.take(found, Clock::now());
    if (found.empty()) {
      say(base::LogLevel::warning, peer.complaint,
          "peer " + to_string(peer.name()) + " cannot be resolved: " + error.message() + ": will try again");
      return;
    }
    find_routes();
  }

  net::io_context& context_;
  std::uint16_t port_;
  bool are_links_;
  Admission admission_;
  base::LogSink& log_;
  AirCounts& counts_;
  Receive receive_;
  udp::resolver resolver_;
  net::steady_timer timer_;
  std::vector<NamedPeer> peers_;
  Guests guests_;
  std::optional<Guests::Sender> speaking_;  ///< the sender of the datagram of this event, if nobody names it
  bool is_named_speaking_ = false;          ///< that sender is a named peer
  std::vector<Link> links_;
  std::map<address, std::shared_ptr<Socket>> sockets_;  // by our own address
  std::map<address, std::string> complaints_;
  bool is_stopped_ = false;
};

Unicast::Unicast(net::io_context& context, UnicastSettings settings, base::LogSink& log, AirCounts& counts,
                 Receive receive)
    : sockets_(std::make_shared<Sockets>(context, std::move(settings), log, counts, std::move(receive))) {
  sockets_->start();
}
Unicast::~Unicast() { sockets_->stop(); }
void Unicast::set_links(const std::vector<Link>& links) { sockets_->set_links(links); }
std::vector<Interface> Unicast::peer_links(const std::vector<Interface>& interfaces) const {
  return sockets_->peer_links(interfaces);
}
void Unicast::send_alone(InterfaceIndex interface, std::string_view to, std::span<const std::byte> datagram) {
  sockets_->send_alone(interface, to, datagram);
}
bool Unicast::is_sender_named() const { return sockets_->is_sender_named(); }
bool Unicast::is_sender_unnamed() const { return sockets_->is_sender_unnamed(); }
void Unicast::answer_sender(base::Duration time) { sockets_->answer_sender(time); }
UnicastCounts Unicast::counts() const { return sockets_->counts(); }
void Unicast::send(InterfaceIndex interface, std::span<const std::byte> datagram) {
  sockets_->send(interface, datagram);
}

}  // namespace geminga::env
