// Two looks at the same daemon, and what they have in common: a moment is no finding.
#ifndef GEMINGA_DOCTOR_STEADY_HPP
#define GEMINGA_DOCTOR_STEADY_HPP

#include "doctor/answers.hpp"

namespace geminga::doctor {

/// The later answers without what may be a matter of the moment: a request that was just stated, a participant whose
/// ontology is being read, an interface on which nothing came in while nothing was sent. Takes out of `later` what
/// `earlier` does not say, too:
/// - of requests those that were not unmatched before;
/// - of participants `hears_us`, and `ontology` where the digest is another one or somebody still reads files here;
/// - of keys `lacks`;
/// - of interfaces `quiet` where it was short before, or where no datagram was sent between the looks though an
/// interval
///   went by.
[[nodiscard]] Answers steady(const Answers& earlier, Answers later);

}  // namespace geminga::doctor

#endif
