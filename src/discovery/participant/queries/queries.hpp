// The answers to `query`, one kind a file; src/discovery/participant/QUERIES.md specifies them.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_QUERIES_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_QUERIES_HPP

#include <cstdint>
#include <expected>

#include "base/time.hpp"
#include "discovery/gcnp/request.hpp"
#include "discovery/matching/matcher.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "discovery/participant/air/air.hpp"
#include "discovery/participant/clients/answering.hpp"
#include "discovery/participant/clients/sessions.hpp"
#include "discovery/participant/knowledge/ontology_reading.hpp"
#include "discovery/participant/knowledge/overlaps.hpp"
#include "discovery/participant/knowledge/resolver.hpp"
#include "discovery/participant/knowledge/self.hpp"
#include "discovery/participant/queries/sides.hpp"
#include "discovery/sealing/seal.hpp"
#include "env/env.hpp"
#include "geminga/error.hpp"

namespace geminga::participant {

/// The parts that lists of participants, services and requests read. They outlive the answer.
struct Listed {
  const env::Env& env;
  const matching::Matcher& matcher;
  const membership::Neighbours& neighbours;
  Resolver& resolver;
};

// Answers that are ready at once. Their cost is linear in what they look through, which is little.
/// `undescribed` is the reason why our own description is not in force; empty where it is, or there is none.
[[nodiscard]] Answer answer_participants(const Listed& by, const Self& self, base::Duration interval,
                                         const Sessions& sessions, const std::string& undescribed);
/// The line of one participant in that answer; nothing where it is not known.
[[nodiscard]] std::optional<Line> participant_line(const Listed& by, const Self& self, base::Duration interval,
                                                   const Sessions& sessions, ParticipantId participant);
/// Either name may be a class expression.
[[nodiscard]] std::expected<Answer, Error> answer_explain(const vocabulary::Vocabulary& vocabulary, Resolver& resolver,
                                                          const gcnp::QueryExplain& query);
[[nodiscard]] Answer answer_concepts(const vocabulary::Vocabulary& vocabulary, const gcnp::QueryConcepts& query);
[[nodiscard]] Answer answer_ontology(const vocabulary::Vocabulary& vocabulary, const OntologyReading& reading,
                                     const membership::Neighbours& neighbours, base::Instant now);
[[nodiscard]] Answer answer_interfaces(const env::Env& env, Air& air);
[[nodiscard]] Answer answer_peers(const Sessions& sessions);
[[nodiscard]] Answer answer_security(const sealing::Seal& seal, const membership::Neighbours& neighbours,
                                     base::Instant now);

/// The answer to `query diagnosis`: `diagnosis` is null while the participant is being asked.
[[nodiscard]] Answer answer_diagnosis(const Diagnoses::Diagnosis* diagnosis, base::Instant now);
/// Our own answer to an inquiry over the air: parts of the answers to `query status`, `interfaces` and `participants`,
/// without names of users, programs, hosts and files. Lines of announcement::max_diagnosis_line_bytes at most.
[[nodiscard]] std::vector<std::string> diagnosis_lines(const Answer& status, const Answer& interfaces,
                                                       const Answer& participants, ParticipantId asker);

// Answers that go through the registry piece by piece. All that they borrow outlives them.
[[nodiscard]] std::expected<Answering, Error> begin_list(const Listed& by, const gcnp::QueryServices& query);
[[nodiscard]] std::expected<Answering, Error> begin_list(const Listed& by, const gcnp::QueryRequests& query);
[[nodiscard]] std::expected<Answering, Error> begin_match(const Listed& by, const Overlaps& overlaps, const Self& self,
                                                          const gcnp::QueryMatch& query);
/// The participants whose descriptions meet the query, best first, each by `line_of`.
[[nodiscard]] std::expected<Answering, Error> begin_participants(
    const Listed& by, const Overlaps& overlaps, const Self& self, const gcnp::QueryParticipants& query,
    std::function<std::optional<Line>(ParticipantId)> line_of);
[[nodiscard]] Answering begin_hearing(const env::Env& env, const membership::NeighbourTable& table);
[[nodiscard]] std::expected<Answering, Error> begin_taxonomy(const Listed& by, const gcnp::QueryTaxonomy& query);
/// The matcher judges a subscription that it is asked about where that is still to be done.
[[nodiscard]] std::expected<Answering, Error> begin_why(matching::Matcher& matcher, const Overlaps& overlaps,
                                                        const membership::Neighbours& neighbours, const Stating& by,
                                                        const gcnp::QueryWhy& query);

}  // namespace geminga::participant

#endif
