#include "participant/announcer.hpp"

#include <algorithm>
#include <utility>

#include "beacon/codec.hpp"
#include "beacon/limits.hpp"
#include "beacon/on_interface.hpp"
#include "participant/own_services.hpp"

namespace geminga::participant {
namespace {

beacon::ScheduleOptions schedule_options(const Settings& settings) {
  return {.interval = std::clamp(settings.interval, beacon::min_interval, beacon::max_interval)};
}

}  // namespace

Announcer::Announcer(Core& core)
    : core_(core),
      boot_(beacon::BootNonce(core.env.random_bits())),
      claim_(core.env.random_bits(), [&core](ParticipantId id) { return core.neighbours.is_known(id); }),
      schedule_(schedule_options(core.settings), core.env.random_bits()) {}

void Announcer::start() {
  claim_.start(core_.env.now());
  core_.neighbours.set_self(claim_.id(), boot_);
}

void Announcer::stop() {
  is_stopping_ = true;
  if (!claim_.is_held()) return;
  farewell_ = claim_.id();
  schedule_.stop(core_.env.now());
}

bool Announcer::is_finished() const {
  return is_stopping_ && (farewell_ == ParticipantId{} || schedule_.is_finished());
}

Announcer::Step Announcer::step_claim() {
  for (;;) {
    if (is_stopping_) return Step::nothing;
    switch (claim_.step(core_.env.now())) {
      case beacon::IdentifierClaim::Step::wait:
        return Step::nothing;
      case beacon::IdentifierClaim::Step::send_claim:
        send(header(beacon::Kind::claim, claim_.id()));
        break;
      case beacon::IdentifierClaim::Step::claimed:
        return Step::claimed;
      case beacon::IdentifierClaim::Step::failed:
        return Step::failed;
    }
  }
}

void Announcer::announce() {
  const base::Instant now = core_.env.now();
  if (is_stopping_) {
    if (farewell_ == ParticipantId{}) return;
    while (schedule_.take(now)) send(header(beacon::Kind::goodbye, farewell_));
    return;
  }
  if (!claim_.is_held()) return;
  if (std::exchange(core_.is_changed, false)) {
    ++revision_;
    state_ = state();
    schedule_.changed(now);
  }
  while (schedule_.take(now)) send(state_);
}

base::Instant Announcer::due() const {
  return is_stopping_ ? schedule_.due() : std::min(claim_.due(), schedule_.due());
}

Announcer::Consequence Announcer::heard(beacon::Hearing hearing, beacon::Kind kind) {
  if (is_stopping_) return Consequence::nothing;
  const base::Instant now = core_.env.now();
  if (hearing == beacon::Hearing::newcomer || hearing == beacon::Hearing::claim) {
    if (claim_.is_held()) schedule_.newcomer(now);
    return Consequence::nothing;
  }
  if (hearing != beacon::Hearing::clash) return Consequence::nothing;
  const ParticipantId lost = claim_.id();
  switch (claim_.conflict(kind, now)) {
    case beacon::IdentifierClaim::Verdict::ignore:
      return Consequence::nothing;
    case beacon::IdentifierClaim::Verdict::answer:
      schedule_.newcomer(now);
      return Consequence::nothing;
    case beacon::IdentifierClaim::Verdict::redrawn:
      core_.neighbours.set_self(claim_.id(), boot_);
      return Consequence::nothing;
    case beacon::IdentifierClaim::Verdict::dropped:
      send(header(beacon::Kind::goodbye, lost));
      schedule_.pause();
      core_.neighbours.set_self(claim_.id(), boot_);
      return Consequence::dropped;
    case beacon::IdentifierClaim::Verdict::failed:
      return Consequence::failed;
  }
  return Consequence::nothing;
}

beacon::Announcement Announcer::header(beacon::Kind kind, ParticipantId id) const {
  beacon::Announcement header;
  header.kind = kind;
  header.group = core_.settings.group;
  header.participant = id;
  header.boot = boot_;
  header.interval = schedule_options(core_.settings).interval;
  header.name = core_.settings.name;
  header.ontology_digest = core_.digest();
  return header;
}

beacon::Announcement Announcer::state() const {
  beacon::Announcement state = header(beacon::Kind::state, claim_.id());
  state.revision = revision_;
  for (const Session* session : core_.peers()) {
    beacon::PeerState peer;
    peer.id = session->peer();
    peer.name = session->name;
    for (const auto& [number, stated] : session->publications) {
      if (stated.is_in_force) peer.publications.push_back({.number = number, .publication = stated.publication});
    }
    for (const auto& [number, stated] : session->subscriptions) {
      if (stated.is_in_force) peer.subscriptions.push_back({.number = number, .subscription = stated.subscription});
    }
    if (!peer.publications.empty() || !peer.subscriptions.empty()) state.peers.push_back(std::move(peer));
  }
  return state;
}

void Announcer::send(beacon::Announcement announcement) {
  const auto& interfaces = core_.env.interfaces();
  for (const env::Interface& interface : interfaces) {
    beacon::Announcement here = beacon::on_interface(announcement, interface, interfaces);
    std::uint64_t& sequence = sequences_[interface.index];
    here.sequence = sequence;
    for (const beacon::Datagram& datagram : beacon::encode(here)) {
      core_.env.send(interface.index, datagram);
      ++sequence;
      ++core_.counters.datagrams_sent;
      ++core_.counters.interfaces[interface.index].sent;
      core_.counters.bytes_sent += datagram.size();
    }
  }
}

}  // namespace geminga::participant
