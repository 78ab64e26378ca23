#include "daemon/preparation.hpp"

#include <utility>

namespace geminga::daemon {

void Preparation::start(std::shared_ptr<const compiled::Ontology> ontology, Done done) {
  ontology_ = std::move(ontology);
  // It holds the ontology on its own account: whoever started it may be gone before it is done.
  background_.start([ontology = ontology_, done = std::move(done)] {
    auto result = std::make_shared<std::unique_ptr<const participant::PreparedOntology>>(
        participant::PreparedOntology::make(*ontology));
    return [result, done] { done(std::move(*result)); };
  });
}

}  // namespace geminga::daemon
