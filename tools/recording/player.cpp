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
  if (auto read = player.read(); !read) return std::unexpected(std::move(read.error()));
  const std::optional<Entry> first = player.next_;
  const auto is_due = [&] {
    // The records of a snapshot are part of it: all lines of its moment are there at once.
    return player.next_->at == first->at || (from && has_come(*player.next_, *from, *first));
  };
  while (player.next_ && is_due()) {
    player.last_ = player.next_->at;
    player.state_.apply(*player.next_);
    if (auto read = player.read(); !read) return std::unexpected(std::move(read.error()));
  }
  if (from && !player.next_) {
    return std::unexpected(Finding{0, 0, "the recording ends before that moment, after " + span_words(player.last_)});
  }
  if (const auto* at = from ? std::get_if<At>(&*from) : nullptr) player.last_ = std::max(player.last_, *at);
  player.begin_ = player.last_;
  player.state_.stand_at(player.begin_);
  return player;
}

std::expected<void, Finding> Player::move_to(std::chrono::nanoseconds played) {
  const At now = begin_ + At(static_cast<At::rep>(std::chrono::duration<double, std::milli>(played).count() * speed_));
  while (next_ && next_->at <= now) {
    last_ = next_->at;
    state_.apply(*next_);
    if (auto more = read(); !more) return more;
  }
  // Behind the end the last moment stays as it is.
  state_.stand_at(next_ ? now : last_);
  return {};
}

std::optional<std::chrono::nanoseconds> Player::next_due() const {
  if (!next_) return std::nullopt;
  const std::chrono::duration<double, std::milli> wait(static_cast<double>((next_->at - begin_).count()) / speed_);
  return std::chrono::ceil<std::chrono::nanoseconds>(wait);
}

}  // namespace geminga::recording
