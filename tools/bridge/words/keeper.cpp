#include "bridge/words/keeper.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "base/text.hpp"

namespace geminga::bridge {
namespace {

/// The daemon takes a bridge for gone that was silent for 3.5 s (relaying::keeper_time).
constexpr std::chrono::seconds hello_spacing{1};

std::string name_of(ParticipantId participant) { return base::to_hex(std::to_underlying(participant), 8); }

}  // namespace

Keeper::Keeper(client::Reactor& reactor, Tally& tally, Shelf& shelf)
    : reactor_(reactor), tally_(tally), shelf_(shelf), hello_(reactor, [this] { greet(); }), giving_(reactor, [this] {
        give();
      }) {}

void Keeper::begin() {
  kept_.clear();
  live_anew();
}

void Keeper::live_anew() {
  life_ = std::uint64_t{chance_()} << 32U | chance_() | 1U;
  greet();
  {
    const std::lock_guard lock(mutex_);
    frames_.clear();
    given_ = 0;
  }
  shelf_.read();
  again_at_ = reactor_.now() + given_again;
  gives_until_ = reactor_.now() + reading_time;
  giving_.set(reactor_.now());
}

void Keeper::end() {
  life_ = 0;
  kept_.clear();
  hello_.set(base::never);
}

void Keeper::leave() {
  for (const auto& [participant, count] : kept_) {
    for (unsigned index = 0; index < count; ++index) shelf_.remove(name_of(participant), index);
  }
  end();
}

void Keeper::on_frame(Word datagram) {
  if (life_ == 0) return;
  const auto frame = keeping::read(datagram);
  if (!frame) return tally_.count("frames of the daemon that are of another version");
  if (const auto* one = std::get_if<keeping::Keep>(&*frame)) keep(*one);
  if (const auto* one = std::get_if<keeping::Drop>(&*frame)) drop(one->participant);
}

void Keeper::keep(const keeping::Keep& frame) {
  const auto known = kept_.find(frame.participant);
  if (known == kept_.end() && kept_.size() == max_kept_participants) {
    return tally_.count("words to keep of too many participants");
  }
  unsigned& count = kept_[frame.participant];
  shelf_.put(name_of(frame.participant), frame.index, frame.envelope);
  count = std::max<unsigned>(count, frame.index + 1U);
  if (frame.index + 1U < frame.count) return;
  while (count > frame.count) shelf_.remove(name_of(frame.participant), --count);
}

void Keeper::drop(ParticipantId participant) {
  const auto known = kept_.find(participant);
  if (known == kept_.end()) return;
  for (unsigned index = 0; index < known->second; ++index) shelf_.remove(name_of(participant), index);
  kept_.erase(known);
}

void Keeper::on_daemon_began() {
  if (life_ == 0) return;
  for (const auto& [participant, count] : std::exchange(kept_, {})) {
    for (unsigned index = 0; index < count; ++index) shelf_.remove(name_of(participant), index);
  }
  live_anew();
}

void Keeper::take(Word word) {
  if (word.empty() || word.size() > keeping::max_kept_bytes) return;
  auto frame = keeping::write(keeping::Kept{word});
  const std::lock_guard lock(mutex_);
  if (frames_.size() == max_waiting_words) {
    ++too_many_;
  } else {
    frames_.push_back(std::move(frame));
  }
}

void Keeper::greet() {
  if (life_ == 0) return;
  if (daemon_ != nullptr) daemon_->tell(keeping::write(keeping::Hello{life_}));
  hello_.set(reactor_.now() + hello_spacing);
}

/// A daemon that is given all at once would lose most of it.
void Keeper::give() {
  const base::Instant now = reactor_.now();
  std::size_t too_many = 0;
  {
    const std::lock_guard lock(mutex_);
    too_many = std::exchange(too_many_, 0);
    if (given_ == frames_.size() && now >= again_at_) {
      given_ = 0;
      again_at_ = base::never;
    }
    for (int i = 0; i < given_at_once && given_ < frames_.size(); ++i, ++given_) {
      if (daemon_ != nullptr) daemon_->tell(frames_[given_]);
    }
    if (now >= gives_until_) frames_.clear();
  }
  for (; too_many > 0; --too_many) tally_.count("kept words over the limit");
  if (now < gives_until_) giving_.set(now + giving_pause);
}

}  // namespace geminga::bridge
