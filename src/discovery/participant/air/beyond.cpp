#include "discovery/participant/air/beyond.hpp"

#include "discovery/announcement/codec.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::participant {
namespace {

using membership::Hearing;

/// Whether the table has taken a word in, so that others are to hear it, too.
bool is_taken(Hearing hearing) {
  return hearing == Hearing::known || hearing == Hearing::newcomer || hearing == Hearing::claim ||
         hearing == Hearing::goodbye || hearing == Hearing::returned;
}

}  // namespace

Beyond::Beyond(const Means& means) : means_(means), voucher_(means.seal) {
  if (means.settings.relay) relay_.emplace(means.env, means.neighbours);
}

const announcement::Announcement* Beyond::unwrap(const announcement::Announcement& relayed, bool is_believed) {
  if (!is_believed) {
    voucher_.refuse(relaying::Refusal::unvouched);
    return nullptr;
  }
  const base::Instant now = means_.env.now();
  const auto word = voucher_.unwrap(relayed, means_.announcer.id(), now);
  if (!word) return nullptr;
  if (!means_.neighbours.is_heard_directly((*word)->participant, now)) return *word;
  voucher_.refuse(relaying::Refusal::near);
  return nullptr;
}

membership::Passage Beyond::passage(std::vector<ParticipantId> through, const env::Interface& on) const {
  membership::Passage passage{.through = std::move(through),
                              .hops = 0,
                              .interface = relaying::link_of(on),
                              .age = {},
                              .loss = 0,
                              .interval = means_.settings.interval,
                              .delay = {}};
  passage.hops = passage.through.size();
  for (const ParticipantId id : passage.through) {
    const auto relay = means_.neighbours.reach(id);
    if (relay) passage.interval = relay->interval;
    if (relay) passage.loss = relay->loss;  // that of the last one counts all hops to it
    passage.delay += passage.interval;
  }
  return passage;
}

membership::Passage Beyond::passage(const announcement::Announcement& relayed, const env::Interface& on) const {
  auto passage = this->passage(relayed.relayed.through, on);
  passage.age = relayed.relayed.age;
  return passage;
}

void Beyond::hear_presence(const announcement::Announcement& presence, const env::Interface& on, Hearing hearing,
                           bool is_believed) {
  if (!is_believed || hearing == Hearing::other_group) return;
  const base::Instant now = means_.env.now();
  const env::InterfaceIndex link = relaying::link_of(on);
  if (hearing == Hearing::known && !presence.behind.empty()) {
    const membership::Passage passage = this->passage({presence.participant}, on);
    means_.neighbours.hear_behind(presence, passage, now);
    if (relay_) relay_->hear_behind(link, presence, passage.interval);
  }
  if (!relay_) return;
  hear_doubts(presence.doubts, link);
  for (const ParticipantId id : relay_->elsewhere(link, presence.lacks)) means_.neighbours.suspect(id, now);
}

/// Those who doubt a participant on one link hear of it through us: we tell what we know, or ask on the other links.
void Beyond::hear_doubts(const std::vector<ParticipantId>& doubts, env::InterfaceIndex link) {
  const base::Instant now = means_.env.now();
  relay_->hear_doubts(link, doubts);
  for (const ParticipantId id : relay_->elsewhere(link, doubts)) {
    const auto reach = means_.neighbours.reach(id);
    if (now - reach->heard < reach->interval) {
      means_.announcer.show();
    } else {
      means_.neighbours.doubt(id, now);
    }
  }
}

Beyond::Links Beyond::links_for(const sealing::Opened& opened, const announcement::Announcement& said,
                                const env::Interface& on) {
  if (!relay_ || !relaying::is_passed_on(said.kind) || said.group != means_.settings.group) return {};
  if (!voucher_.note(opened, said, means_.env.now())) return {};
  return links_for(said, on, opened.session.has_value());
}

Beyond::Links Beyond::links_for(const announcement::Announcement& word, const env::Interface& on,
                                bool is_sealed) const {
  if (!relay_ || !means_.announcer.is_held()) return {};
  const bool is_vouched = is_sealed && seals();
  return relay_->links_for(word.participant, relaying::link_of(on), means_.announcer.id(), is_vouched);
}

void Beyond::pass_on(const relaying::Word& word, const Links& links, Hearing hearing) {
  if (links.empty() || !is_taken(hearing)) return;
  const auto relayed = voucher_.wrap(word, means_.announcer.id());
  if (!relayed) return;
  if (hearing == Hearing::newcomer) {
    testimony_due_ = std::min(testimony_due_, means_.env.now() + first_testimony_delay);
    last_testimony_ = means_.env.now() + last_testimony_delay;
  }
  for (const env::InterfaceIndex link : links) {
    if (!relay_->may_pass()) {
      voucher_.refuse(relaying::Refusal::too_many);
      return;
    }
    say(link, *relayed);
    relay_->repeat(link, *relayed);
  }
}

std::vector<announcement::Behind> Beyond::behind(const env::Interface& on) const {
  if (!relay_ || (!seals() && !on.is_named_peer)) return {};
  return relay_->behind(relaying::link_of(on), means_.announcer.id());
}

std::vector<std::pair<std::string_view, std::uint64_t>> Beyond::refusals() const {
  std::vector<std::pair<std::string_view, std::uint64_t>> refusals;
  for (std::size_t i = 0; i < relaying::refusal_count; ++i) {
    const auto refusal = static_cast<relaying::Refusal>(i);
    refusals.emplace_back(to_string(refusal), voucher_.refused(refusal));
  }
  return refusals;
}

void Beyond::proceed() {
  if (!relay_ || !means_.announcer.is_held()) return;
  while (const auto repeat = relay_->take_repeat()) say(repeat->link, repeat->relayed);
  if (relay_->takes_over()) means_.announcer.show();
  if (testimony_due_ > means_.env.now()) return;
  means_.announcer.show();
  testimony_due_ = testimony_due_ < last_testimony_ ? last_testimony_ : base::never;
}

void Beyond::say(env::InterfaceIndex link, const announcement::Announcement& relayed) {
  for (const announcement::Datagram& text : announcement::encode(relayed)) means_.announcer.outlet().send(link, text);
  relay_->count();
}

}  // namespace geminga::participant
