#include "discovery/sealing/rejection.hpp"

#include <array>

namespace geminga::sealing {

std::string_view to_string(Rejection rejection) {
  static constexpr std::array<std::string_view, rejection_count> words{
      "plain",     "too-large", "too-short",  "other-version", "unknown-key", "replayed", "forged",
      "malformed", "unproved",  "downgraded", "own",           "unreadable",  "copied"};
  return words.at(static_cast<std::size_t>(rejection));
}

}  // namespace geminga::sealing
