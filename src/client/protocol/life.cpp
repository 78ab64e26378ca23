#include "client/protocol/life.hpp"

#include <cstdint>
#include <random>

namespace geminga::client {

Life new_life() {
  std::random_device chance;
  std::uint64_t bits = 0;
  while (bits == 0) bits = (std::uint64_t{chance()} << 32) | chance();
  return Life{bits};
}

}  // namespace geminga::client
