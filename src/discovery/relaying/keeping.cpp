#include "discovery/relaying/keeping.hpp"

#include <algorithm>

namespace geminga::relaying {

void Keeping::take(const announcement::Announcement& said, const Word& word) {
  if (said.kind != announcement::Kind::state && said.kind != announcement::Kind::change) return;
  HeardWord heard{.relayed = {.word = {word.datagram.begin(), word.datagram.end()},
                              .age = word.age,
                              .through = {word.through.begin(), word.through.end()},
                              .source = std::string(word.source)},
                  .heard = env_.now()};
  if (chains_[said.participant].add(WordPlace::of(said), std::move(heard))) look_at(said.participant);
}

void Keeping::hear_keeper(env::InterfaceIndex link, std::uint64_t life) {
  Keeper& keeper = keepers_[link];
  keeper.until = env_.now() + keeper_time;
  if (keeper.life == life) return;
  keeper.life = life;
  keeper.turns.clear();
  keeper.agenda.clear();
  for (const auto& [participant, chain] : chains_) set_turn(keeper, participant, env_.now());
}

void Keeping::look_at(ParticipantId participant) {
  if (!chains_.contains(participant)) return;
  for (auto& [link, keeper] : keepers_) set_turn(keeper, participant, env_.now());
  // Without a keeper nobody else looks after the words of those who are gone.
  if (keepers_.empty() && !neighbours_.is_known(participant)) chains_.erase(participant);
}

void Keeping::look_at_all() {
  for (auto& [link, keeper] : keepers_) {
    for (const auto& [participant, chain] : chains_) set_turn(keeper, participant, env_.now());
  }
}

void Keeping::set_turn(Keeper& keeper, ParticipantId participant, base::Instant at) {
  Turn& turn = keeper.turns[participant];
  keeper.agenda.erase({turn.at, participant});
  turn.at = at;
  keeper.agenda.insert({at, participant});
}

std::optional<Keeping::Errand> Keeping::next(ParticipantId self) {
  const base::Instant now = env_.now();
  if (paused_until_ > now) return std::nullopt;
  const std::size_t gone = std::erase_if(keepers_, [now](const auto& one) { return one.second.until <= now; });
  if (gone > 0 && keepers_.empty()) {
    std::erase_if(chains_, [this](const auto& one) { return !neighbours_.is_known(one.first); });
  }
  for (auto& [link, keeper] : keepers_) {
    while (!keeper.agenda.empty() && keeper.agenda.begin()->first <= now) {
      if (left_ == 0) {
        left_ = kept_at_once;
        paused_until_ = now + keeping_pause;
        return std::nullopt;
      }
      if (const auto errand = attend(link, keeper, keeper.agenda.begin()->second, self)) {
        --left_;
        return errand;
      }
    }
  }
  return std::nullopt;
}

std::optional<Keeping::Errand> Keeping::attend(env::InterfaceIndex link, Keeper& keeper, ParticipantId participant,
                                               ParticipantId self) {
  const base::Instant now = env_.now();
  Turn& turn = keeper.turns[participant];
  const auto reach = neighbours_.reach(participant);
  if (!reach || !relay_.speaks_for(*reach, link, self)) {
    const bool was_kept = std::exchange(turn.is_kept, false);
    if (reach) {
      set_turn(keeper, participant, now + silent_again);
    } else {
      keeper.agenda.erase({turn.at, participant});
      keeper.turns.erase(participant);
      chains_.erase(participant);
    }
    return was_kept ? std::optional(Errand{Errand::What::drop, link, participant}) : std::nullopt;
  }
  const auto chain = chains_.find(participant);
  if (chain == chains_.end() || !chain->second.leads_to(reach->revision)) {
    const bool asks = std::exchange(turn.was_partial, !turn.was_partial);
    set_turn(keeper, participant, now + (asks ? keep_again : partial_again));
    return asks ? std::optional(Errand{Errand::What::ask, link, participant}) : std::nullopt;
  }
  turn.is_kept = true;
  turn.was_partial = false;
  set_turn(keeper, participant, now + keep_again);
  return Errand{Errand::What::keep, link, participant, &chain->second};
}

base::Instant Keeping::due() const {
  base::Instant due = base::never;
  for (const auto& [link, keeper] : keepers_) {
    if (!keeper.agenda.empty()) due = std::min(due, keeper.agenda.begin()->first);
  }
  return due == base::never ? due : std::max(due, paused_until_);
}

}  // namespace geminga::relaying
