#include "daemon/ontology/preparation.hpp"

#include <utility>

namespace geminga::daemon {

void Preparation::start(const vocabulary::Vocabulary& vocabulary, Done done) {
  started_ = vocabulary::OntologyMark(vocabulary);
  // The thread has its own reference to the vocabulary and may outlive the participant's.
  background_.start([vocabulary, done = std::move(done)] {
    return [prepared = vocabulary.with_expressions(), done] { done(prepared); };
  });
}

}  // namespace geminga::daemon
