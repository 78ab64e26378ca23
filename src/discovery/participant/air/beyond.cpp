#include "discovery/participant/air/beyond.hpp"

#include "discovery/announcement/codec.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/keeping/frame.hpp"

namespace geminga::participant {
namespace {

using membership::Hearing;

/// Whether the table has taken a word in, so that others are to hear it, too.
bool is_taken(Hearing hearing) {
  return hearing == Hearing::known || hearing == Hearing::newcomer || hearing == Hearing::claim ||
         hearing == Hearing::goodbye || hearing == Hearing::returned;
}

}  // namespace

Beyond::Beyond(const Means& means) : means_(means), voucher_(means.seal), recall_(means.seal) {
  if (!means.settings.relay) return;
  relay_.emplace(means.env, means.table.neighbours());
  keeping_.emplace(means.env, means.table.neighbours(), *relay_);
}

const announcement::Announcement* Beyond::unwrap(const announcement::Announcement& relayed, bool is_believed) {
  if (!is_believed) {
    voucher_.refuse(relaying::Refusal::unvouched);
    return nullptr;
  }
  const base::Instant now = means_.env.now();
  const auto word = voucher_.unwrap(relayed, means_.announcer.id(), now);
  if (!word) return nullptr;
  if (!means_.table.neighbours().is_heard_directly((*word)->participant, now)) return *word;
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
    const auto relay = means_.table.neighbours().reach(id);
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
    means_.table.hear_behind(presence, passage, now);
    if (relay_) relay_->hear_behind(link, presence, passage.interval);
  }
  if (!relay_) return;
  hear_doubts(presence.doubts, link);
  for (const ParticipantId id : relay_->elsewhere(link, presence.lacks)) means_.table.suspect(id, now);
}

/// Those who doubt a participant on one link hear of it through us: we tell what we know, or ask on the other links.
void Beyond::hear_doubts(const std::vector<ParticipantId>& doubts, env::InterfaceIndex link) {
  const base::Instant now = means_.env.now();
  relay_->hear_doubts(link, doubts);
  for (const ParticipantId id : relay_->elsewhere(link, doubts)) {
    const auto reach = means_.table.neighbours().reach(id);
    if (now - reach->heard < reach->interval) {
      means_.announcer.show();
    } else {
      means_.table.doubt(id, now);
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

void Beyond::pass_on(const relaying::Word& word, const announcement::Announcement& said, const Links& links,
                     Hearing hearing) {
  if (!is_taken(hearing)) return;
  if (keeping_ && sealing::is_sealed(word.datagram)) keeping_->take(said, word);
  if (links.empty()) return;
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

void Beyond::hear_frame(std::span<const std::byte> datagram, const env::Interface& on) {
  const auto frame = keeping::read(datagram);
  // Without a seal nobody could tell what was kept from what the server has made.
  if (!frame || !seals()) return;
  if (const auto* hello = std::get_if<keeping::Hello>(&*frame); hello != nullptr && keeping_ && on.is_named_peer) {
    keeping_->hear_keeper(relaying::link_of(on), hello->life);
  }
  if (const auto* kept = std::get_if<keeping::Kept>(&*frame)) recall_.take(kept->envelope, means_.env.now());
}

std::vector<announcement::Announcement> Beyond::recall(const announcement::Announcement& presence,
                                                       sealing::Session session, Hearing hearing) {
  std::vector<announcement::Announcement> all;
  if (hearing != Hearing::known || recall_.pending() == 0) return all;
  for (const announcement::Behind& one : presence.behind) {
    if (one.participant == means_.announcer.id() || means_.table.neighbours().is_known(one.participant)) continue;
    auto words = recall_.recall(session, presence.participant, one);
    recalled_ += words.empty() ? 0 : 1;
    std::ranges::move(words, std::back_inserter(all));
  }
  return all;
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
  if (relay_->takes_over()) {
    means_.announcer.show();
    keeping_->look_at_all();
  }
  keep_what_is_due();
  if (testimony_due_ > means_.env.now()) return;
  means_.announcer.show();
  testimony_due_ = testimony_due_ < last_testimony_ ? last_testimony_ : base::never;
}

void Beyond::keep_what_is_due() {
  using What = relaying::Keeping::Errand::What;
  while (const auto errand = keeping_->next(means_.announcer.id())) {
    if (errand->what == What::keep && seals()) keep(*errand);
    if (errand->what == What::ask) means_.table.suspect(errand->participant, means_.env.now());
    if (errand->what == What::drop) {
      means_.announcer.outlet().hand(errand->link, keeping::write(keeping::Drop{errand->participant}));
    }
  }
}

void Beyond::keep(const relaying::Keeping::Errand& errand) {
  const base::Instant now = means_.env.now();
  const auto& words = errand.chain->words();
  for (std::size_t i = 0; i < words.size(); ++i) {
    const announcement::Relayed& heard = words[i].relayed;
    const auto relayed =
        voucher_.wrap({.datagram = heard.word,
                       .age = std::min(heard.age + (now - words[i].heard), announcement::max_relayed_age),
                       .through = heard.through,
                       .source = heard.source},
                      means_.announcer.id());
    if (!relayed) return;
    const auto envelope = means_.seal.seal_kept(announcement::encode(*relayed).front(), now);
    if (envelope.size() > keeping::max_kept_bytes) return;
    means_.announcer.outlet().hand(errand.link,
                                   keeping::write(keeping::Keep{.participant = errand.participant,
                                                                .index = static_cast<std::uint8_t>(i),
                                                                .count = static_cast<std::uint8_t>(words.size()),
                                                                .envelope = envelope}));
    ++kept_;
  }
}

void Beyond::say(env::InterfaceIndex link, const announcement::Announcement& relayed) {
  for (const announcement::Datagram& text : announcement::encode(relayed)) means_.announcer.outlet().send(link, text);
  relay_->count();
}

}  // namespace geminga::participant
