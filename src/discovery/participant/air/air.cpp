#include "discovery/participant/air/air.hpp"

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "base/address.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/keeping/frame.hpp"
#include "discovery/participant/air/reach_judge.hpp"

namespace geminga::participant {
namespace {

/// Where we come so late to a deadline, the host slept or had no time for us, and what others have said meanwhile is
/// still to be read: no neighbour is given up until there was time for it.
constexpr base::Duration late_after = std::chrono::milliseconds(300);
constexpr base::Duration time_to_catch_up = std::chrono::milliseconds(500);

const env::Interface* find(const env::Env& env, env::InterfaceIndex index) {
  const auto& interfaces = env.interfaces();
  const auto found = std::ranges::find(interfaces, index, &env::Interface::index);
  return found == interfaces.end() ? nullptr : &*found;
}

}  // namespace

Air::Air(env::Env& env, const TeamSettings& settings, OwnState own)
    : env_(env),
      settings_(settings),
      own_(std::move(own)),
      table_(settings.group),
      seal_([&env] { return env.random_bits(); }),
      introductions_(table_, seal_, settings_),
      reader_(settings.shared ? settings.shared->reader : own_reader_),
      announcer_({.env = env,
                  .settings = settings_,
                  .own = own_,
                  .table = table_,
                  .seal = seal_,
                  .dual_stack = dual_stack_,
                  .deaf_hosts = deaf_hosts_,
                  .introductions = introductions_,
                  .counters = counters_,
                  .behind = [this](const env::Interface& on) { return beyond_.behind(on); }}),
      beyond_({.env = env, .settings = settings_, .table = table_, .seal = seal_, .announcer = announcer_}) {}

void Air::start() {
  seal_.adopt(settings_.sealing, env_.now());
  table_.set_secret(env_.random_bits());
  table_.set_judge([&env = env_](const std::string& address, const std::string& observed) {
    return judged_reach(address, observed, env.route(address));
  });
  if (settings_.shared) table_.set_offers(settings_.shared->offers);
  announcer_.start();
}

void Air::adopt(const sealing::Policy& policy) {
  seal_.adopt(policy, env_.now());
  if (!is_sealed()) deaf_hosts_.forget_all();
  announcer_.show();
}

std::optional<Announcer::Consequence> Air::hear(env::InterfaceIndex interface, std::string_view source,
                                                std::span<const std::byte> datagram, ParticipantId served) {
  const auto consequence = take_in(interface, source, datagram, served);
  if (const auto complaint = seal_.take_complaint())
    env_.log().write(base::LogLevel::warning, *complaint, {.code = "sealing"});
  return consequence;
}

std::optional<Announcer::Consequence> Air::take_in(env::InterfaceIndex interface, std::string_view source,
                                                   std::span<const std::byte> datagram, ParticipantId served) {
  ++counters_.datagrams_received;
  counters_.bytes_received += datagram.size();
  const env::Interface* on = find(env_, interface);
  if (on == nullptr) return std::nullopt;  // It came in just before the interface went away.
  ++counters_.interfaces[interface].received;
  if (keeping::is_frame(datagram)) {
    if (env_.is_sender_named()) beyond_.hear_frame(datagram, *on);
    return std::nullopt;
  }
  const sealing::Arrival arrival{.interface = interface,
                                 .interface_name = on->name,
                                 .source = source,
                                 .now = env_.now(),
                                 .is_alone = env_.is_sender_named() || env_.is_sender_unnamed()};
  const auto opened = open(datagram, arrival);
  const auto* read = opened ? decode(*opened, arrival) : nullptr;
  if (read == nullptr) return std::nullopt;
  const announcement::Announcement& heard = *read;
  if (served != announcer_.id() && heard.participant == served) {
    // A participant that has the identifier which we are giving up is heard once our own services have another one.
    ++counters_.hearings.at(std::to_underlying(membership::Hearing::clash));
    return std::nullopt;
  }
  const bool is_sealed = opened->session.has_value();
  if (heard.kind == announcement::Kind::inquiry || heard.kind == announcement::Kind::diagnosis) {
    hear_exchange(heard, is_sealed);
    return std::nullopt;
  }
  if (heard.kind == announcement::Kind::relayed) return take_in_relayed(heard, *on, is_sealed, served);
  return take_in_direct({.announcement = heard, .opened = *opened, .datagram = datagram, .arrival = arrival, .on = *on},
                        served);
}

std::optional<sealing::Opened> Air::open(std::span<const std::byte> datagram, const sealing::Arrival& arrival) {
  auto opened = seal_.open(datagram, arrival);
  if (opened) return *std::move(opened);
  if (opened.error() == sealing::Rejection::own) ++counters_.hearings.at(std::to_underlying(membership::Hearing::own));
  // The sender has to hear what it is asked.
  if (opened.error() == sealing::Rejection::unproved) env_.answer_sender(base::Duration(0));
  return std::nullopt;
}

const announcement::Announcement* Air::decode(const sealing::Opened& opened, const sealing::Arrival& arrival) {
  const auto read = reader_.read(opened.text);
  if (!read) {
    ++counters_.undecodable.at(static_cast<std::size_t>(read.error()));
    seal_.reject_unreadable(opened, arrival);
    return nullptr;
  }
  return seal_.attribute(opened, (*read)->participant, arrival) ? *read : nullptr;
}

std::optional<Announcer::Consequence> Air::take_in_direct(const Received& received, ParticipantId served) {
  const announcement::Announcement& heard = received.announcement;
  const bool is_sealed = received.opened.session.has_value();
  const auto links = beyond_.links_for(received.opened, heard, received.on);
  const bool is_about_us = heard.participant == announcer_.id();  // it may be a lie, and others hear it
  if (!is_about_us && DualStack::is_said_twice(heard, received.on)) return std::nullopt;
  const membership::Hearing hearing = table_.hear(heard, {.interface = received.arrival.interface,
                                                          .interface_name = received.arrival.interface_name,
                                                          .source = received.arrival.source,
                                                          .now = received.arrival.now,
                                                          .is_sealed = is_sealed,
                                                          .is_alone = received.arrival.is_alone});
  ++counters_.hearings.at(std::to_underlying(hearing));
  if (heard.kind == announcement::Kind::presence) {
    one_way_.hear(heard, table_, received.arrival.source, received.on.name, env_.log());
    if (is_sealed && !recall(heard, *received.opened.session, hearing, received.on, served)) {
      return Announcer::Consequence::failed;
    }
    beyond_.hear_presence(heard, received.on, hearing, is_sealed || env_.is_sender_named());
  } else {
    beyond_.pass_on({.datagram = received.datagram, .source = received.arrival.source}, heard, links, hearing);
  }
  reach(heard, received.on, received.arrival.source);
  if (is_sealed) meet(heard, received.on);
  speak_to(heard, received.on, hearing, is_sealed);
  return announcer_.heard({.announcement = heard,
                           .hearing = hearing,
                           .datagram = received.datagram,
                           .source = received.arrival.source,
                           .on = received.on});
}

bool Air::recall(const announcement::Announcement& presence, sealing::Session session, membership::Hearing hearing,
                 const env::Interface& on, ParticipantId served) {
  for (const announcement::Announcement& kept : beyond_.recall(presence, session, hearing)) {
    if (take_in_relayed(kept, on, true, served) == Announcer::Consequence::failed) return false;
  }
  return true;
}

std::optional<Announcer::Consequence> Air::take_in_relayed(const announcement::Announcement& heard,
                                                           const env::Interface& on, bool is_sealed,
                                                           ParticipantId served) {
  const announcement::Announcement* word = beyond_.unwrap(heard, is_sealed || env_.is_sender_named());
  if (word == nullptr || (served != announcer_.id() && word->participant == served)) return std::nullopt;
  const announcement::Relayed& relayed = heard.relayed;
  const membership::Passage passage = beyond_.passage(heard, on);
  const auto links = beyond_.links_for(*word, on, is_sealed);
  const membership::Hearing hearing = table_.hear(*word, {.interface = on.index,
                                                          .interface_name = on.name,
                                                          .source = relayed.source,
                                                          .now = env_.now(),
                                                          .is_sealed = is_sealed,
                                                          .passage = &passage});
  ++counters_.hearings.at(std::to_underlying(hearing));
  if (hearing == membership::Hearing::own) return std::nullopt;
  beyond_.pass_on({.datagram = relayed.word, .age = relayed.age, .through = relayed.through, .source = relayed.source},
                  *word, links, hearing);
  return announcer_.heard(
      {.announcement = *word, .hearing = hearing, .datagram = relayed.word, .source = relayed.source, .on = on});
}

const Diagnoses::Diagnosis* Air::diagnosis_of(ParticipantId participant) {
  if (const auto token = diagnoses_.ask(participant, env_.random_bits(), env_.now()))
    announcer_.exchange(announcement::Kind::inquiry, participant, *token, {});
  return diagnoses_.answer_of(participant, env_.now());
}

void Air::hear_exchange(const announcement::Announcement& heard, bool is_sealed) {
  const base::Instant now = env_.now();
  if (heard.group != settings_.group || heard.partner != announcer_.id()) return;
  if (!table_.neighbours().is_known(heard.participant)) return;
  if (heard.kind == announcement::Kind::diagnosis) {
    diagnoses_.hear_diagnosis(heard, now);
    return;
  }
  // A seal has proved that its sender asks at this moment; without one the owner has named the host that it came from.
  const bool may_ask = this->is_sealed() ? is_sealed : env_.is_sender_named();
  if (!settings_.diagnoses || !may_ask || !diagnoses_.may_answer(now)) return;
  announcer_.exchange(announcement::Kind::diagnosis, heard.participant, heard.token, own_.diagnosis(heard.participant));
}

void Air::reach(const announcement::Announcement& heard, const env::Interface& on, std::string_view source) {
  if (heard.kind == announcement::Kind::goodbye) deaf_hosts_.forget(heard.participant);
  if (!is_sealed() || heard.kind != announcement::Kind::presence) return;
  if (!table_.witnesses().is_deaf_to_us(heard.participant)) {
    deaf_hosts_.hear(heard.participant);
  } else {
    deaf_hosts_.hear_deaf({.participant = heard.participant, .interface = on.index, .address = std::string(source)},
                          settings_.interval, env_.now());
  }
}

void Air::meet(const announcement::Announcement& heard, const env::Interface& on) {
  if (!is_sealed() || heard.group != settings_.group || !table_.neighbours().is_known(heard.participant)) return;
  for (const announcement::Introduction& one : heard.introductions) {
    const auto address = base::parse_address(one.address);
    const bool is_ours = std::ranges::any_of(env_.interfaces(), [&](const env::Interface& interface) {
      return std::ranges::find(interface.addresses, one.address) != interface.addresses.end();
    });
    if (!address || is_ours || address->scope() == base::AddressScope::loopback) continue;
    if (one.participant == announcer_.id() || table_.neighbours().is_known(one.participant)) continue;
    deaf_hosts_.introduce({.participant = one.participant, .interface = on.index, .address = one.address},
                          settings_.interval, env_.now());
  }
}

void Air::reach_lost(base::Instant now) {
  if (!is_sealed() || table_.next_deadline() > now) return;
  table_.neighbours().for_each([&](const membership::Neighbour& one) {
    if (one.deadline > now || one.paths.empty() || !one.through.empty() || one.paths.front().addresses.empty()) return;
    deaf_hosts_.lose({.participant = one.id,
                      .interface = one.paths.front().interface,
                      .address = one.paths.front().addresses.front()},
                     settings_.interval, now);
  });
}

/// Sends copies to participants that multicast does not reach, for as long as they may live: those that speak IPv6
/// alone, and those that have proved to be of the team and send to us alone.
void Air::speak_to(const announcement::Announcement& heard, const env::Interface& on, membership::Hearing hearing,
                   bool is_sealed) {
  using membership::Hearing;
  if (hearing == Hearing::own || hearing == Hearing::clash || hearing == Hearing::other_group) return;
  const bool is_guest = is_sealed && env_.is_sender_unnamed();
  if (!on.ipv6_side_of && !is_guest) return;
  const auto known = table_.neighbours().find(heard.participant);
  const base::Duration time =
      announcement::contest_intervals * std::max(known ? known->interval : base::Duration(0), settings_.interval);
  dual_stack_.hear(heard, on, env_.now() + time);
  if (is_guest && heard.kind != announcement::Kind::goodbye) env_.answer_sender(time);
}

void Air::shed() {
  const std::size_t given_up = table_.shed(env_.now());
  env_.log().write(base::LogLevel::warning,
                   "memory is short: " + std::to_string(given_up) +
                       " participants that were heard last are given up, and further ones "
                       "have to wait",
                   {.code = "memory_short"});
}

void Air::expire() {
  const base::Instant now = env_.now();
  if (const base::Instant due = table_.next_deadline(); due < now - late_after) {
    table_.postpone(now + time_to_catch_up);
  }
  reach_lost(now);
  if (const std::size_t lost = table_.expire(now); lost > 0) announcer_.lost(lost);
}

std::vector<membership::Change> Air::take_changes() {
  auto changes = table_.take_changes();
  for (const membership::Change& change : changes) {
    const auto* gone = std::get_if<membership::RemoveParticipant>(&change);
    if (gone == nullptr) continue;
    beyond_.forget(gone->participant);
    if (gone->reason == membership::Departure::expired) ++counters_.lost;
  }
  return changes;
}

}  // namespace geminga::participant
