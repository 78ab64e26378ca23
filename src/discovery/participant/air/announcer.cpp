#include "discovery/participant/air/announcer.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/address.hpp"
#include "base/text.hpp"
#include "discovery/announcement/announceable.hpp"
#include "discovery/announcement/codec.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/announcement/on_interface.hpp"
#include "discovery/membership/schedule/pace.hpp"

namespace geminga::participant {
namespace {

membership::ScheduleOptions schedule_options(const TeamSettings& settings) {
  return {.interval = std::clamp(settings.interval, announcement::min_interval, announcement::max_interval)};
}

/// "10.0.0.66 on wlan0"
std::string origin(const Heard& heard) { return std::string(heard.source) + " on " + heard.on.name; }

/// Whether a datagram from this address can be our own. An interface does not show its IPv6 link-local address where it
/// has another one, so no link-local address can be ruled out.
bool may_be_ours(const env::Env& env, std::string_view source) {
  const auto address = base::parse_address(source);
  if (!address || (address->is_ipv6() && address->scope() == base::AddressScope::link_local)) return true;
  return std::ranges::any_of(env.interfaces(), [&](const env::Interface& interface) {
    return std::ranges::find(interface.addresses, source) != interface.addresses.end();
  });
}

}  // namespace

Announcer::Announcer(const Means& means)
    : means_(means),
      boot_(announcement::BootNonce(means.env.random_bits())),
      claim_(means.env.random_bits(),
             [&neighbours = means.table.neighbours()](ParticipantId id) { return neighbours.is_known(id); }),
      schedule_(schedule_options(means.settings), means.env.random_bits()),
      outlet_({.env = means.env, .seal = means.seal, .deaf_hosts = means.deaf_hosts, .counters = means.counters},
              means.env.random_bits()) {}

void Announcer::start() {
  claim_.start(means_.env.now());
  means_.table.set_self(claim_.id(), boot_);
}

void Announcer::stop() {
  is_stopping_ = true;
  if (!claim_.is_held()) return;
  farewell_ = claim_.id();
  schedule_.stop(means_.env.now());
}

bool Announcer::is_finished() const {
  return is_stopping_ && (farewell_ == ParticipantId{} || schedule_.is_finished());
}

Announcer::Step Announcer::step_claim() {
  for (;;) {
    if (is_stopping_) return Step::nothing;
    switch (claim_.step(means_.env.now())) {
      case membership::IdentifierClaim::Step::wait:
        return Step::nothing;
      case membership::IdentifierClaim::Step::send_claim:
        send(header(announcement::Kind::claim, claim_.id()));
        break;
      case membership::IdentifierClaim::Step::claimed:
        return Step::claimed;
      case membership::IdentifierClaim::Step::failed:
        return Step::failed;
    }
  }
}

void Announcer::announce() {
  const base::Instant now = means_.env.now();
  if (is_stopping_) {
    if (farewell_ == ParticipantId{}) return;
    while (schedule_.take(now) != membership::Schedule::Say::nothing)
      send(header(announcement::Kind::goodbye, farewell_));
    return;
  }
  if (!claim_.is_held()) return;
  if (std::exchange(is_changed_, false)) {
    is_untold_ = true;
    schedule_.set_loss(means_.table.neighbours().loss());
    schedule_.changed(is_new_to_others() ? membership::Schedule::Say::state : membership::Schedule::Say::change, now);
  }
  const std::uint8_t doublings = membership::doublings_for(means_.table.seasoned(), doublings_);
  if (doublings < doublings_ || !schedule_.is_slowing()) doublings_ = doublings;
  schedule_.set_doublings(doublings_, now);
  schedule_.ask({.lacks = means_.table.lacks_anybody(now), .doubts = means_.table.doubts_anybody()}, now);
  if (means_.table.witnesses().is_unlike(now)) schedule_.differ(now);
  schedule_.search(search_.spacing(means_.table.neighbours().size(), interval(), now), now);
  be_silent_on_ipv6_sides();
  schedule_.challenge(means_.seal.asks(now) || means_.seal.is_asked(now), now);
  for (;;) {
    switch (schedule_.take(now)) {
      case membership::Schedule::Say::nothing:
      case membership::Schedule::Say::goodbye:
        return;
      case membership::Schedule::Say::state:
        update_log(now);
        schedule_.set_size(send(whole_state()));
        break;
      case membership::Schedule::Say::change:
        update_log(now);
        send(change());
        break;
      case membership::Schedule::Say::presence:
        schedule_.set_loss(means_.table.neighbours().loss());
        send(presence());
        break;
    }
  }
}

void Announcer::be_silent_on_ipv6_sides() {
  for (const env::Interface& interface : means_.env.interfaces()) {
    if (!means_.dual_stack.speaks_on(interface, means_.seal, means_.env.now()))
      means_.seal.be_silent_on(interface.index);
  }
}

void Announcer::exchange(announcement::Kind kind, ParticipantId partner, std::uint64_t token,
                         std::vector<std::string> lines) {
  if (is_stopping_ || !claim_.is_held()) return;
  announcement::Announcement said = header(kind, claim_.id());
  std::tie(said.partner, said.token, said.lines) = std::tuple(partner, token, std::move(lines));
  send(said);
}

void Announcer::show() { schedule_.doubted(means_.env.now()); }

/// Whether nothing was announced under this identifier, or not on these interfaces.
bool Announcer::is_new_to_others() {
  if (log_.state().participant == claim_.id() && announced_on_ == means_.env.interfaces()) return false;
  announced_on_ = means_.env.interfaces();
  log_.begin_anew();
  return true;
}

void Announcer::update_log(base::Instant now) {
  if (std::exchange(is_untold_, false)) {
    means_.table.set_revision(++revision_);
    changed_ = now;
  }
  if (log_.state().revision != revision_ || log_.state().participant != claim_.id()) log_.update(state(), now);
}

announcement::Announcement Announcer::whole_state() const {
  announcement::Announcement state = log_.state();
  state.doublings = doublings_;
  return state;
}

announcement::Announcement Announcer::change() const {
  std::optional<announcement::Announcement> change = log_.change();
  if (!change) return whole_state();
  change->doublings = doublings_;
  return std::move(*change);
}

base::Instant Announcer::due() const {
  return is_stopping_ ? schedule_.due() : std::min(claim_.due(), schedule_.due());
}

Announcer::Consequence Announcer::heard(const Heard& heard) {
  if (is_stopping_) return Consequence::nothing;
  switch (heard.hearing) {
    case membership::Hearing::newcomer:
    case membership::Hearing::claim:
      schedule_.newcomer(means_.env.now());
      if (!seems_next_incarnation(heard)) return Consequence::nothing;
      schedule_.deny(means_.env.now());
      if (has_our_lasting_identity(heard)) report_copy(heard);
      return Consequence::nothing;
    case membership::Hearing::known:
    case membership::Hearing::stranger:
      if (heard.announcement.kind == announcement::Kind::presence) heard_presence(heard);
      return Consequence::nothing;
    case membership::Hearing::own:
      heard_own(heard);
      return Consequence::nothing;
    case membership::Hearing::clash:
      return heard_clash(heard);
    default:
      return Consequence::nothing;
  }
}

/// Whether a participant begins under our name and from our address, or with our lasting identity. Others may take it
/// for our next incarnation, and us for gone.
bool Announcer::seems_next_incarnation(const Heard& heard) const {
  if (!claim_.is_held() || heard.announcement.boot == boot_) return false;
  const std::string& name = means_.settings.name;
  return has_our_lasting_identity(heard) ||
         (!name.empty() && heard.announcement.name == name && may_be_ours(means_.env, heard.source));
}

bool Announcer::has_our_lasting_identity(const Heard& heard) const {
  return heard.announcement.lasting != 0 && heard.announcement.lasting == means_.settings.lasting;
}

/// Reports a copy of our disk: we run, so that participant is not our next incarnation.
void Announcer::report_copy(const Heard& heard) {
  const base::Instant now = means_.env.now();
  if (copy_reported_ && now - *copy_reported_ < copy_report_spacing) return;
  copy_reported_ = now;
  means_.env.log().write(
      base::LogLevel::warning,
      (heard.announcement.name.empty() ? "a participant" : base::printable(heard.announcement.name)) + " (" +
          origin(heard) +
          ") has our lasting identity, too, so one of us is a copy of the other's disk: remove the file `identity` "
          "from its state folder and start it again",
      {.participant = to_string(heard.announcement.participant), .code = "copied_identity"});
}

/// A presence says what its sender has heard of us and of others.
void Announcer::heard_presence(const Heard& heard) {
  const base::Instant now = means_.env.now();
  const auto names = [](const std::vector<ParticipantId>& ids, ParticipantId id) {
    return std::ranges::find(ids, id) != ids.end();
  };
  const announcement::Announcement& presence = heard.announcement;
  if (names(presence.lacks, claim_.id())) {
    if (heard.hearing == membership::Hearing::known) {
      schedule_.lacked(now);
    } else {
      schedule_.lacked_by_stranger(now);
    }
  }
  if (heard.hearing != membership::Hearing::known) return;
  if (presence.participant == testifies_for_) {
    schedule_.leave_testimony();
    testifies_for_ = {};
  }
  const bool misses_us = means_.table.misses_us(presence, changed_, interval(), now);
  const bool may_lack_change = misses_us && now - changed_ < membership::doubtful_intervals * interval();
  const membership::Difference difference = means_.table.compare(presence, now);
  if (difference.unknown == membership::Unknown::us) schedule_.lacked(now);
  if (difference.lacks_our_state) schedule_.seems_lacked(now);
  if (may_lack_change) schedule_.differ(now);
  if (means_.table.doubts_anybody() && means_.table.hear_doubts(presence.doubts, now)) {
    schedule_.asked_by_another(now);
  }
  if (names(presence.doubts, claim_.id())) {
    schedule_.doubted(now);
    return;
  }
  const auto is_heard = [&](ParticipantId id) { return means_.table.witnesses().has_heard(id, now); };
  const auto doubted = std::ranges::find_if(presence.doubts, is_heard);
  if (doubted == presence.doubts.end()) return;
  const bool is_one = std::find_if(doubted + 1, presence.doubts.end(), is_heard) == presence.doubts.end();
  const bool is_first = schedule_.bear_witness(now);
  testifies_for_ = is_one && (is_first || testifies_for_ == *doubted) ? *doubted : ParticipantId{};
}

Announcer::Consequence Announcer::heard_clash(const Heard& heard) {
  const base::Instant now = means_.env.now();
  const ParticipantId lost = claim_.id();
  clash_from_ = origin(heard);
  switch (claim_.conflict(heard.announcement.kind, now)) {
    case membership::IdentifierClaim::Verdict::ignore:
      return Consequence::nothing;
    case membership::IdentifierClaim::Verdict::answer:
      ++means_.counters.contested;
      schedule_.contested(now);
      report(heard);
      return Consequence::nothing;
    case membership::IdentifierClaim::Verdict::kept:
      ++means_.counters.contested;
      schedule_.contradict(now);
      report(heard);
      return Consequence::nothing;
    case membership::IdentifierClaim::Verdict::redrawn:
      ++means_.counters.redraws;
      means_.table.set_self(claim_.id(), boot_);
      return Consequence::nothing;
    case membership::IdentifierClaim::Verdict::dropped:
      ++means_.counters.redraws;
      ++means_.counters.clashes;
      means_.env.log().write(
          base::LogLevel::warning,
          "another participant (" + clash_from_ + ") has our identifier " + to_string(lost) + ", too: taking a new one",
          {.participant = to_string(lost), .code = "clash"});
      send(header(announcement::Kind::goodbye, lost));
      schedule_.pause();
      means_.table.set_self(claim_.id(), boot_);
      return Consequence::nothing;
    case membership::IdentifierClaim::Verdict::failed:
      return Consequence::failed;
  }
  return Consequence::nothing;
}

/// A datagram with our boot nonce is our own echo, or a forgery that all others hear, too.
void Announcer::heard_own(const Heard& heard) {
  if (!claim_.is_held() || heard.announcement.participant != claim_.id()) return;
  if (may_be_ours(means_.env, heard.source) && outlet_.has_sent(heard.datagram)) return;
  ++means_.counters.contradicted;
  schedule_.contradict(means_.env.now());
  report(heard);
}

void Announcer::report(const Heard& heard) {
  if (!contest_.hear(origin(heard), means_.env.now())) return;
  means_.env.log().write(
      base::LogLevel::warning,
      contest_.from() + " announces in our name (identifier " + to_string(claim_.id()) +
          "): we keep it and contradict. If this goes on, a program there forges or replays announcements: find "
          "that host, or keep it off this network",
      {.participant = to_string(claim_.id()), .code = "contested"});
}

void Announcer::end_contest() {
  if (!contest_.has_ended(means_.env.now())) return;
  means_.env.log().write(
      base::LogLevel::info,
      "nobody else announces in our name any more; " + std::to_string(contest_.heard()) + " datagrams did",
      {.participant = to_string(claim_.id()), .code = "contest_ended"});
}

std::string Announcer::failure() const {
  return "no participant identifier could be claimed: each of " + std::to_string(membership::max_claim_attempts) +
         " was announced by somebody else at once, the last by " + clash_from_ +
         ": a program there forges announcements: find that host, or keep it off this network";
}

base::Duration Announcer::interval() const {
  return announcement::stretched(schedule_options(means_.settings).interval, doublings_);
}

announcement::Announcement Announcer::header(announcement::Kind kind, ParticipantId id) const {
  announcement::Announcement header;
  header.kind = kind;
  header.group = means_.settings.group;
  header.participant = id;
  header.boot = boot_;
  header.interval = schedule_options(means_.settings).interval;
  header.doublings = doublings_;
  header.name = means_.settings.name;
  header.ontology_digest = means_.own.ontology_digest();
  header.lasting = means_.settings.lasting;
  return header;
}

announcement::Announcement Announcer::presence() {
  announcement::Announcement presence = header(announcement::Kind::presence, claim_.id());
  presence.revision = revision_;
  membership::Report report = means_.table.report(means_.env.now());
  presence.witness = std::move(report.witness);
  presence.lacks = std::move(report.lacks);
  presence.doubts = std::move(report.doubts);
  return presence;
}

announcement::Announcement Announcer::state() const {
  announcement::Announcement state = header(announcement::Kind::state, claim_.id());
  state.revision = revision_;
  state.peers = means_.own.peers();
  return state;
}

std::size_t Announcer::send(const announcement::Announcement& announcement) {
  std::size_t most = 0;
  const auto& interfaces = means_.env.interfaces();
  for (const env::Interface& interface : interfaces) {
    // A participant that speaks IPv6 alone hears of us by the first datagram, and answers it.
    if (!means_.dual_stack.speaks_on(interface, means_.seal, means_.env.now()) && sequences_.contains(interface.index))
      continue;
    std::uint64_t& sequence = sequences_[interface.index];
    const auto encode = [&](const announcement::Announcement& all) {
      announcement::Announcement here = announcement::on_interface(all, interface, interfaces);
      here.sequence = sequence;
      means_.introductions.add_to(here, interface.index, means_.env.now());
      if (here.kind == announcement::Kind::presence && means_.behind) here.behind = means_.behind(interface);
      return announcement::encode(here);
    };
    auto datagrams = encode(announcement);
    if (datagrams.empty()) datagrams = encode(whole_state());  // a change that is too large
    for (const announcement::Datagram& text : datagrams) {
      outlet_.send(interface.index, text);
      if (announcement.kind < announcement::Kind::inquiry) ++sequence;
    }
    most = std::max(most, datagrams.size());
  }
  return most;
}

}  // namespace geminga::participant
