#include "recording/player.hpp"

#include <algorithm>
#include <utility>
#include <variant>

namespace geminga::recording {

std::expected<void, Finding> Player::read() {
  next_.reset();
  auto entry = reader_.next();
  if (!entry) return std::unexpected(std::move(entry.error()));
  next_ = std::move(*entry);
  return {};
}

std::expected<Player, Finding> Player::begin(Reader reader, double speed, std::optional<Moment> from) {
  Player player(std::move(reader), speed);
  if (auto started = player.start(from); !started) return std::unexpected(std::move(started.error()));
  return player;
}

std::expected<void, Finding> Player::start(const std::optional<Moment>& from) {
  if (auto first_read = read(); !first_read) return first_read;
  const std::optional<Entry> first = next_;
  const auto is_due = [&] {
    // The records of a snapshot are part of it: all lines of its moment are there at once.
    return next_->at == first->at || (from && has_come(*next_, *from, *first));
  };
  while (next_ && is_due()) {
    last_ = next_->at;
    state_.apply(*next_);
    if (auto more = read(); !more) return more;
  }
  const auto* at = from ? std::get_if<At>(&*from) : nullptr;
  if (at != nullptr && next_) last_ = std::max(last_, *at);
  begin_ = now_ = last_;
  state_.stand_at(now_);
  const bool is_last_moment = at != nullptr && *at <= last_;
  if (!from || next_ || is_last_moment) return {};
  return std::unexpected(Finding{0, 0, "the recording ends before that moment, after " + span_words(last_)});
}

std::expected<void, Finding> Player::seek(const Moment& moment) {
  if (!reader_.rewind()) {
    return std::unexpected(Finding{0, 0, "this recording cannot be read again: give its file to seek in it"});
  }
  state_ = State();
  last_ = {};
  return start(moment);
}

void Player::set_speed(double speed) {
  speed_ = speed;
  begin_ = now_;
}

std::expected<void, Finding> Player::move_to(std::chrono::nanoseconds played) {
  const At now = begin_ + At(static_cast<At::rep>(std::chrono::duration<double, std::milli>(played).count() * speed_));
  while (next_ && next_->at <= now) {
    last_ = next_->at;
    state_.apply(*next_);
    if (auto more = read(); !more) return more;
  }
  // Behind the end the last moment stays as it is.
  now_ = next_ ? now : last_;
  state_.stand_at(now_);
  return {};
}

std::optional<std::chrono::nanoseconds> Player::next_due() const {
  if (!next_) return std::nullopt;
  const std::chrono::duration<double, std::milli> wait(static_cast<double>((next_->at - begin_).count()) / speed_);
  return std::chrono::ceil<std::chrono::nanoseconds>(wait);
}

}  // namespace geminga::recording
