// The part of our next presence that is about others.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_REPORT_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_REPORT_HPP

#include <vector>

#include "discovery/announcement/announcement.hpp"

namespace geminga::membership {

/// The fields of these names in announcement::Announcement.
struct Report {
  announcement::Witness witness;
  std::vector<ParticipantId> lacks;
  std::vector<ParticipantId> doubts;
};

}  // namespace geminga::membership

#endif
