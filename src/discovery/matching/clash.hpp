// Two different concepts with the same 32-bit identity: their number connects neither with whoever states it. Two that
// state the number are connected all the same.
#ifndef GEMINGA_DISCOVERY_MATCHING_CLASH_HPP
#define GEMINGA_DISCOVERY_MATCHING_CLASH_HPP

#include <string>

#include "geminga/service.hpp"

namespace geminga::matching {

/// What a local peer is to be told of its publication or subscription, whose identity has such a number.
struct Clash {
  ServiceKey to;
  std::string text;  ///< one line: which concepts, and what to do
};

}  // namespace geminga::matching

#endif
