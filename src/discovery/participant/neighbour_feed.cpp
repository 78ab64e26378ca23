#include "discovery/participant/neighbour_feed.hpp"

#include <algorithm>
#include <utility>

#include "discovery/announcement/codec.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/participant/own_services.hpp"
#include "discovery/participant/telling.hpp"

namespace geminga::participant {
namespace {

/// Where we come so late to a deadline, the host slept or had no time for us, and what others have said meanwhile is
/// still to be read: nobody is taken for gone until there was time for it.
constexpr base::Duration late_after = std::chrono::milliseconds(300);
constexpr base::Duration time_to_catch_up = std::chrono::milliseconds(500);

matching::Reason reason_of(membership::Departure departure) {
  switch (departure) {
    case membership::Departure::withdrawn:
      return matching::Reason::withdrawn;
    case membership::Departure::expired:
      return matching::Reason::expired;
    case membership::Departure::left:
      return matching::Reason::left;
  }
  return matching::Reason::withdrawn;
}

/// Does one change to the registry. Entries have no deadline of their own there: the neighbour table, which hears every
/// sign of life, is the only one that decides when somebody is gone.
struct Feed {
  matching::Matcher& matcher;

  void operator()(membership::PutPublication& put) const {
    matcher.put(registry::PublicationEntry{.key = put.key,
                                           .publication = std::move(put.publication),
                                           .peer_name = std::move(put.peer_name),
                                           .participant_name = std::move(put.participant_name),
                                           .updated = put.heard});
  }
  void operator()(membership::PutSubscription& put) const {
    matcher.put(registry::SubscriptionEntry{.key = put.key,
                                            .subscription = std::move(put.subscription),
                                            .peer_name = std::move(put.peer_name),
                                            .participant_name = std::move(put.participant_name),
                                            .updated = put.heard});
  }
  void operator()(const membership::RemovePublication& gone) const {
    matcher.remove_publication(gone.key, reason_of(gone.reason));
  }
  void operator()(const membership::RemoveSubscription& gone) const {
    matcher.remove_subscription(gone.key, reason_of(gone.reason));
  }
  void operator()(const membership::RemoveParticipant& gone) const {
    matcher.begin_departure(gone.participant, reason_of(gone.reason));
  }
};

/// One of our own requests, under the identifier that is held now.
void return_next(Core& core) {
  const auto [stream, number] = core.returning.back();
  core.returning.pop_back();
  const auto session = core.sessions.find(stream);
  if (session == core.sessions.end() || session->second->is_leaving) return;
  core.worked += cost_of_statement;
  return_one(core, *session->second, number);
}

/// Who would not hear us otherwise is spoken to for as long as he may live: who speaks IPv6 alone, and who has proved
/// that he is of the team and sends to us alone.
void speak_to(Core& core, const announcement::Announcement& announcement, const env::Interface& on,
              membership::Hearing hearing, bool is_sealed) {
  using membership::Hearing;
  if (hearing == Hearing::own || hearing == Hearing::clash || hearing == Hearing::other_group) return;
  const bool is_guest = is_sealed && core.env.is_sender_unnamed();
  if (!on.twin_of && !is_guest) return;
  const auto known = core.neighbours.find(announcement.participant);
  const base::Duration time =
      announcement::contest_intervals * std::max(known ? known->interval : base::Duration(0), core.settings.interval);
  core.twins.hear(announcement, on, core.env.now() + time);
  if (is_guest && announcement.kind != announcement::Kind::goodbye) core.env.answer_sender(time);
}

void feed_next(Core& core) {
  core.overlaps.begin_step();
  if (core.matcher.depart_next() || core.matcher.rejudge_next()) return;
  if (!core.returning.empty()) return return_next(core);
  membership::Change change = core.neighbour_queue.pop();
  std::visit(Feed{core.matcher}, change);
}

}  // namespace

bool is_feed_due(const Core& core) {
  return core.matcher.is_departing() || core.matcher.has_stale() || !core.returning.empty() ||
         !core.neighbour_queue.is_empty();
}

void proceed_feed(Core& core, Work most) {
  const Work begin = core.work();
  while (is_feed_due(core) && core.work() - begin < most) {
    feed_next(core);
    deliver_events(core);
    core.worked += cost_of_entry;
  }
}

void feed(Core& core) {
  const bool is_behind = is_feed_due(core);
  for (membership::Change& change : core.neighbours.take_changes()) core.neighbour_queue.push(std::move(change));
  // A feed that is behind already goes on in turns. Else a flood of datagrams would leave no time for the turns of
  // clients.
  if (!is_behind) proceed_feed(core, work_in_turn);
}

Announcer::Consequence hear(Core& core, Announcer& announcer, env::InterfaceIndex interface, std::string_view source,
                            std::span<const std::byte> datagram) {
  ++core.counters.datagrams_received;
  core.counters.bytes_received += datagram.size();
  const env::Interface* on = core.find(interface);
  if (on == nullptr) return Announcer::Consequence::nothing;  // It came in just before the interface went away.
  ++core.counters.interfaces[interface].received;
  const sealing::Arrival arrival{
      .interface = interface, .interface_name = on->name, .source = source, .now = core.env.now()};
  const auto opened = core.seal.open(datagram, arrival);
  if (!opened) {
    if (opened.error() == sealing::Rejection::own)
      ++core.counters.hearings.at(std::to_underlying(membership::Hearing::own));
    // He has to hear what he is asked.
    if (opened.error() == sealing::Rejection::unproved) core.env.answer_sender(base::Duration(0));
    return Announcer::Consequence::nothing;
  }
  const announcement::Announcement& announcement = core.heard;
  if (const auto error = announcement::decode(opened->text, core.heard)) {
    ++core.counters.undecodable.at(static_cast<std::size_t>(*error));
    core.seal.reject_unreadable(*opened, arrival);
    return Announcer::Consequence::nothing;
  }
  if (!core.seal.attribute(*opened, announcement.participant, arrival)) return Announcer::Consequence::nothing;
  if (core.id != announcer.id() && announcement.participant == core.id) {
    // Whoever else has the identifier that we are giving up is heard once our own services have another one.
    ++core.counters.hearings.at(std::to_underlying(membership::Hearing::clash));
    return Announcer::Consequence::nothing;
  }
  const bool is_about_us = announcement.participant == announcer.id();  // it may be a lie, and others hear it
  if (!is_about_us && Twins::is_said_twice(announcement, *on)) return Announcer::Consequence::nothing;
  const membership::Hearing hearing = core.neighbours.hear(
      announcement, {.interface = interface, .interface_name = on->name, .source = source, .now = core.env.now()});
  ++core.counters.hearings.at(std::to_underlying(hearing));
  speak_to(core, announcement, *on, hearing, opened->session.has_value());
  feed(core);
  if (core.expressions.take_waiting(core.vocabulary(), core.env.now())) core.ontology_change.place_again();
  return announcer.heard(
      {.announcement = announcement, .hearing = hearing, .datagram = datagram, .source = source, .on = *on});
}

void expire(Core& core, Announcer& announcer) {
  const base::Instant now = core.env.now();
  if (const base::Instant due = core.neighbours.next_deadline(); due < now - late_after) {
    core.neighbours.postpone(now + time_to_catch_up);
  }
  if (const std::size_t lost = core.neighbours.expire(now); lost > 0) announcer.lost(lost);
  feed(core);
}

}  // namespace geminga::participant
