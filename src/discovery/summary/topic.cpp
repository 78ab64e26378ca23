#include "discovery/summary/topic.hpp"

#include "base/hash.hpp"
#include "base/text.hpp"

namespace geminga::summary {

std::string subject_word(const Topic& topic) {
  if (topic.digest == 0) return "i" + base::to_hex(base::hash64(topic.iri), 16);
  return "r" + base::to_hex(topic.digest, 16) + "x" + std::to_string(topic.rank);
}

}  // namespace geminga::summary
