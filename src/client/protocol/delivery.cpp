#include "client/protocol/delivery.hpp"

#include "client/protocol/converter.hpp"
#include "client/protocol/limits.hpp"

namespace geminga::client {

std::expected<bool, std::string> Delivery::deliver(const Frame& frame, Carrier carrier, const ServiceEvent& provider,
                                                   base::Instant now) {
  std::uint64_t missed = 0;
  if (frame.life != no_life) {
    const auto gap = carrier == Carrier::forgeable ? sequence_.take_unproved(frame.life, frame.sequence, now)
                                                   : sequence_.take(frame.life, frame.sequence);
    if (!gap) return false;
    missed = *gap;
  }
  count_.missed += missed;
  auto converted = convert(conversions_, provider.convert, frame.payload, provider.via);
  if (!converted) {
    ++count_.dropped;
    return std::unexpected(std::move(converted.error()));
  }
  ++count_.received;
  Message message{frame.life, frame.sequence, missed, std::move(*converted)};
  if (carrier == Carrier::stream) {
    inbox_.put_streamed(std::move(message));
  } else {
    const std::size_t lost = inbox_.put_datagram(std::move(message));
    count_.received -= lost;
    count_.missed += lost;
  }
  return true;
}

void Delivery::count_missed_at_end(Life life, std::uint64_t last, Carrier carrier) {
  const std::uint64_t missed = sequence_.missed_at_end(life, last);
  if (carrier != Carrier::forgeable || missed <= max_sequence_step) count_.missed += missed;
}

}  // namespace geminga::client
