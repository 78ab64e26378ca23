// The words of GCNP for events.
#include "discovery/matching/event.hpp"

#include "base/assert.hpp"

namespace geminga::matching {

std::string_view to_string(Reason reason) {
  switch (reason) {
    case Reason::withdrawn:
      return "withdrawn";
    case Reason::expired:
      return "expired";
    case Reason::left:
      return "left";
    case Reason::outranked:
      return "outranked";
    case Reason::changed:
      return "changed";
    case Reason::renamed:
      return "renamed";
  }
  base::assertion_failed("a reason has a word", __FILE__, __LINE__);
}

}  // namespace geminga::matching
