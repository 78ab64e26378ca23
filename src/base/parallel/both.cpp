#include "base/parallel/both.hpp"

#include "base/parallel/crew.hpp"
#include "base/parallel/room.hpp"

namespace geminga::parallel {

void do_both(unsigned threads, const std::function<void()>& first, const std::function<void()>& second) {
  if (threads > 1 && has_room_for(1)) {
    Crew crew(2);
    if (crew.size() == 2) return crew.run([&](unsigned me) { me == 0 ? first() : second(); }, [] {});
  }
  first();
  second();
}

}  // namespace geminga::parallel
