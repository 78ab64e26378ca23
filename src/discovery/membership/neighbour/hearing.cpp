#include "discovery/membership/neighbour/hearing.hpp"

#include <array>
#include <utility>

namespace geminga::membership {
namespace {

constexpr std::array<std::string_view, hearing_count> words = {
    "own",  "clash",  "claim",     "newcomer", "known", "goodbye",       "other-group", "stale",
    "full", "copied", "elsewhere", "rival",    "leap",  "contradiction", "returned",    "stranger"};

}  // namespace

std::string_view to_string(Hearing hearing) { return words[std::to_underlying(hearing)]; }

}  // namespace geminga::membership
