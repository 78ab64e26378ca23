#include "discovery/participant/air/air.hpp"

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "discovery/announcement/codec.hpp"
#include "discovery/announcement/limits.hpp"

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
      neighbours_(settings.group),
      seal_([&env] { return env.random_bits(); }),
      announcer_({.env = env,
                  .settings = settings_,
                  .own = own_,
                  .neighbours = neighbours_,
                  .seal = seal_,
                  .dual_stack = dual_stack_,
                  .counters = counters_}) {}

void Air::start() {
  seal_.adopt(settings_.sealing, env_.now());
  neighbours_.set_secret(env_.random_bits());
  announcer_.start();
}

void Air::adopt(const sealing::Policy& policy) {
  seal_.adopt(policy, env_.now());
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
  const sealing::Arrival arrival{
      .interface = interface, .interface_name = on->name, .source = source, .now = env_.now()};
  const auto opened = seal_.open(datagram, arrival);
  if (!opened) {
    if (opened.error() == sealing::Rejection::own)
      ++counters_.hearings.at(std::to_underlying(membership::Hearing::own));
    // The sender has to hear what it is asked.
    if (opened.error() == sealing::Rejection::unproved) env_.answer_sender(base::Duration(0));
    return std::nullopt;
  }
  if (const auto error = announcement::decode(opened->text, heard_)) {
    ++counters_.undecodable.at(static_cast<std::size_t>(*error));
    seal_.reject_unreadable(*opened, arrival);
    return std::nullopt;
  }
  if (!seal_.attribute(*opened, heard_.participant, arrival)) return std::nullopt;
  if (served != announcer_.id() && heard_.participant == served) {
    // A participant that has the identifier which we are giving up is heard once our own services have another one.
    ++counters_.hearings.at(std::to_underlying(membership::Hearing::clash));
    return std::nullopt;
  }
  const bool is_about_us = heard_.participant == announcer_.id();  // it may be a lie, and others hear it
  if (!is_about_us && DualStack::is_said_twice(heard_, *on)) return std::nullopt;
  const membership::Hearing hearing = neighbours_.hear(heard_, {.interface = interface,
                                                                .interface_name = on->name,
                                                                .source = source,
                                                                .now = env_.now(),
                                                                .is_sealed = opened->session.has_value()});
  ++counters_.hearings.at(std::to_underlying(hearing));
  if (heard_.kind == announcement::Kind::presence) one_way_.hear(heard_, neighbours_, source, on->name, env_.log());
  speak_to(*on, hearing, opened->session.has_value());
  return announcer_.heard(
      {.announcement = heard_, .hearing = hearing, .datagram = datagram, .source = source, .on = *on});
}

/// Sends copies to participants that multicast does not reach, for as long as they may live: those that speak IPv6
/// alone, and those that have proved to be of the team and send to us alone.
void Air::speak_to(const env::Interface& on, membership::Hearing hearing, bool is_sealed) {
  using membership::Hearing;
  if (hearing == Hearing::own || hearing == Hearing::clash || hearing == Hearing::other_group) return;
  const bool is_guest = is_sealed && env_.is_sender_unnamed();
  if (!on.ipv6_side_of && !is_guest) return;
  const auto known = neighbours_.find(heard_.participant);
  const base::Duration time =
      announcement::contest_intervals * std::max(known ? known->interval : base::Duration(0), settings_.interval);
  dual_stack_.hear(heard_, on, env_.now() + time);
  if (is_guest && heard_.kind != announcement::Kind::goodbye) env_.answer_sender(time);
}

void Air::shed() {
  const std::size_t given_up = neighbours_.shed(env_.now());
  env_.log().write(base::LogLevel::warning,
                   "memory is short: " + std::to_string(given_up) +
                       " participants that were heard last are given up, and further ones "
                       "have to wait",
                   {.code = "memory_short"});
}

void Air::expire() {
  const base::Instant now = env_.now();
  if (const base::Instant due = neighbours_.next_deadline(); due < now - late_after) {
    neighbours_.postpone(now + time_to_catch_up);
  }
  if (const std::size_t lost = neighbours_.expire(now); lost > 0) announcer_.lost(lost);
}

std::vector<membership::Change> Air::take_changes() {
  auto changes = neighbours_.take_changes();
  for (const membership::Change& change : changes) {
    const auto* gone = std::get_if<membership::RemoveParticipant>(&change);
    if (gone != nullptr && gone->reason == membership::Departure::expired) ++counters_.lost;
  }
  return changes;
}

}  // namespace geminga::participant
