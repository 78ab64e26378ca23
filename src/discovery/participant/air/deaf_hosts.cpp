#include "discovery/participant/air/deaf_hosts.hpp"

#include <algorithm>
#include <utility>

namespace geminga::participant {

DeafHosts::Host* DeafHosts::find(ParticipantId participant) {
  const auto found = std::ranges::find(hosts_, participant, [](const Host& one) { return one.way.participant; });
  return found == hosts_.end() ? nullptr : &*found;
}

void DeafHosts::hear_deaf(const Way& way, base::Duration interval, base::Instant now) {
  if (Host* known = find(way.participant)) {
    known->way = way;
    known->cause = Cause::deaf;
    if (std::exchange(known->is_reached, false)) pause(*known, now);
    return;
  }
  add(way, Cause::deaf, interval, now);
}

void DeafHosts::lose(const Way& way, base::Duration interval, base::Instant now) {
  forget(way.participant);
  add(way, Cause::lost, interval, now);
}

void DeafHosts::introduce(const Way& way, base::Duration interval, base::Instant now) {
  if (find(way.participant) == nullptr) add(way, Cause::introduced, interval, now);
}

void DeafHosts::hear(ParticipantId participant) {
  Host* known = find(participant);
  if (known == nullptr) return;
  known->is_reached = known->cause == Cause::deaf && known->octets > 0;
  if (!known->is_reached) forget(participant);
}

void DeafHosts::forget(ParticipantId participant) {
  std::erase_if(hosts_, [&](const Host& one) { return one.way.participant == participant; });
}

void DeafHosts::add(const Way& way, Cause cause, base::Duration interval, base::Instant now) {
  if (hosts_.size() == max_deaf_hosts) {
    const auto least = std::ranges::min_element(hosts_, {}, &Host::cause);
    if (least->cause >= cause) return;
    hosts_.erase(least);
  }
  hosts_.push_back(
      {.way = way, .cause = cause, .interval = interval, .begin = now, .end = now + try_intervals * interval});
}

void DeafHosts::pause(Host& host, base::Instant now) {
  const auto doublings = std::min<std::size_t>(host.tries - 1, 16);
  const auto intervals =
      std::min<std::int64_t>(std::int64_t{first_pause_intervals} << doublings, longest_pause_intervals);
  host.begin = now + intervals * host.interval;
  host.end = host.begin + try_intervals * host.interval;
  host.octets = 0;
  ++host.tries;
}

std::vector<std::string> DeafHosts::take(env::InterfaceIndex interface, std::size_t octets, base::Instant now) {
  std::vector<std::string> addresses;
  for (Host& host : hosts_) {
    if (host.is_reached) {
      if (host.way.interface != interface) continue;
      octets_sent_ += octets;
      addresses.push_back(host.way.address);
      continue;
    }
    if (now >= host.end || (now >= host.begin && host.octets + octets > max_try_bytes)) pause(host, now);
    if (host.is_given_up()) continue;
    if (now < host.begin || host.way.interface != interface) continue;
    host.octets += octets;
    octets_sent_ += octets;
    addresses.push_back(host.way.address);
  }
  std::erase_if(hosts_, [](const Host& one) { return one.is_given_up(); });
  return addresses;
}

}  // namespace geminga::participant
