#include "env/asio/guests.hpp"

#include <algorithm>

namespace geminga::env {

void Guests::answer(const Sender& sender, base::Duration time, Clock::time_point now) {
  const auto is_same = [&](const Sender& other) { return other.to == sender.to && other.via == sender.via; };
  const auto known = std::ranges::find_if(guests_, is_same, &Guest::sender);
  if (time == base::Duration(0)) {
    if (known != guests_.end() && known->until > now) return;
    if (now - second_ >= std::chrono::seconds(1)) {
      second_ = now;
      answers_ = 0;
    }
    std::erase_if(answered_once_, is_same);
    if (answers_ == max_answers_per_second) return;
    ++answers_;
    answered_once_.push_back(sender);
    return;
  }
  std::erase_if(answered_once_, is_same);
  if (known != guests_.end()) {
    *known = {sender, std::max(known->until, now + time)};
    return;
  }
  if (guests_.size() == room_) guests_.erase(std::ranges::min_element(guests_, {}, &Guest::until));
  guests_.push_back({sender, now + time});
}

std::vector<Route> Guests::take_routes(std::size_t octets, InterfaceIndex interface, Clock::time_point now) {
  std::vector<Route> routes;
  std::erase_if(guests_, [&](const Guest& guest) { return guest.until <= now; });
  for (const Guest& guest : guests_) {
    if (guest.sender.interface == interface) routes.push_back({guest.sender.to, guest.sender.via});
  }
  std::erase_if(answered_once_, [&](const Sender& sender) {
    if (sender.interface != interface || octets > max_answer_ratio * sender.octets) return false;
    routes.push_back({sender.to, sender.via});
    return true;
  });
  return routes;
}

std::size_t Guests::count(Clock::time_point now) const {
  return static_cast<std::size_t>(std::ranges::count_if(guests_, [&](const Guest& one) { return one.until > now; }));
}

}  // namespace geminga::env
