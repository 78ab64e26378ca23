#include "discovery/participant/knowledge/work.hpp"

#include "discovery/matching/matcher.hpp"
#include "discovery/participant/knowledge/expressions.hpp"
#include "discovery/participant/knowledge/overlaps.hpp"

namespace geminga::participant {

Work WorkMeter::done() const {
  return added_ + matcher_.judged() * cost_of_judgement + matcher_.filed() * cost_of_filing +
         expressions_.counts().classified * cost_of_expression + overlaps_.counts().decided * cost_of_overlap;
}

}  // namespace geminga::participant
