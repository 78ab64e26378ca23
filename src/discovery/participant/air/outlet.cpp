#include "discovery/participant/air/outlet.hpp"

#include <string>

namespace geminga::participant {

void Outlet::send(env::InterfaceIndex interface, std::span<const std::byte> text) {
  const base::Instant now = means_.env.now();
  const std::span<const std::byte> datagram = means_.seal.seal(text, interface, now);
  sent_.add(datagram);
  means_.env.send(interface, datagram);
  for (const std::string& address : means_.deaf_hosts.take(interface, datagram.size(), now))
    means_.env.send_alone(interface, address, datagram);
  ++means_.counters.datagrams_sent;
  ++means_.counters.interfaces[interface].sent;
  means_.counters.bytes_sent += datagram.size();
}

void Outlet::hand(env::InterfaceIndex link, std::span<const std::byte> frame) {
  means_.env.send(link, frame);
  ++means_.counters.datagrams_sent;
  ++means_.counters.interfaces[link].sent;
  means_.counters.bytes_sent += frame.size();
}

}  // namespace geminga::participant
