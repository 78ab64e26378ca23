#include "daemon/preparation.hpp"

#include <utility>

namespace geminga::daemon {

void Preparation::start(const vocabulary::Vocabulary& vocabulary, Done done) {
  started_ = vocabulary::OntologyMark(vocabulary);
  // The thread has a reference of its own to the vocabulary: whoever started it may be gone before it is done.
  background_.start([vocabulary, done = std::move(done)] {
    return [prepared = vocabulary.with_expressions(), done] { done(prepared); };
  });
}

}  // namespace geminga::daemon
