#include "discovery/matching/offers.hpp"

#include "discovery/matching/candidates.hpp"
#include "discovery/matching/conversions/converter.hpp"

namespace geminga::matching {

using registry::PublicationEntry;
using registry::StoredPublication;

Offers::Offers(const Editions& editions, const Preparation& preparation)
    : editions_(editions), preparation_(preparation) {
  open_index(editions.in_force());
}

void Offers::open_index(const Edition& edition) { table_.set_class_count(index_size(edition), edition.generation); }

const StoredPublication& Offers::add(PublicationEntry entry) {
  const StoredPublication& stored = table_.insert(std::move(entry), {});
  if (stored.slot >= known_.size()) known_.resize(stored.slot + 1);
  known(stored) = {};
  known(stored).arrival = ++arrivals_;
  take_in(stored);
  return stored;
}

std::shared_ptr<const PublicationEntry> Offers::replace(const StoredPublication& stored, PublicationEntry entry) {
  auto before = table_.replace(stored, std::move(entry), {});
  take_in(stored);
  return before;
}

void Offers::take_in(const StoredPublication& stored) {
  const Publication& offered = stored.entry.publication;
  known(stored).audience =
      Audience::is_stated(offered) ? std::make_unique<const Audience>(Audience::parse(offered)) : nullptr;
  file(stored, editions_.in_force());
  if (editions_.are_both_filed()) file(stored, editions_.other());
}

void Offers::retire(const std::vector<const StoredPublication*>& publications, Reason reason) {
  std::vector<ServiceKey> keys;
  for (const auto* one : publications) {
    known(*one).leaves = reason;
    keys.push_back(one->entry.key);
  }
  for (const Edition* edition : {&editions_.in_force(), &editions_.other()}) {
    if (edition->converters == nullptr || edition->converters->is_empty()) continue;
    edition->converters->erase(keys);
    filed_ += edition->converters->take_work();
  }
}

void Offers::erase(const StoredPublication& stored) {
  filed_ += 1 + stored.classes[std::to_underlying(editions_.in_force().generation)].size();
  table_.erase(stored);
}

void Offers::file(const StoredPublication& stored, const Edition& edition) {
  Known& publication = known(stored);
  const auto generation = std::to_underlying(edition.generation);
  publication.classes[generation] = preparation_.classes(stored.entry, edition.vocabulary);
  const Attributes& attributes = stored.entry.publication.attributes;
  publication.signatures[generation] =
      has_signature(attributes) ? std::make_unique<const Signature>(signature_of(attributes, edition.vocabulary))
                                : nullptr;
  if (!publication.leaves && (is_converter(attributes) || !edition.converters->is_empty())) {
    edition.converters->put(stored.entry, audience(publication), publication.arrival);
    filed_ += edition.converters->take_work();
  }
  const FilingPlan plan = FilingPlan::of_publication(publication.classes[generation], edition);
  table_.refile(stored, plan.filing());
  filed_ += 1 + plan.size();
}

void Offers::unfile(const StoredPublication& stored, const Edition& edition) {
  const auto generation = std::to_underlying(edition.generation);
  filed_ += 1 + stored.classes[generation].size();
  table_.unfile(stored, edition.generation);
  known(stored).classes[generation] = {};
  known(stored).signatures[generation] = nullptr;
}

Offer Offers::offer(const StoredPublication& stored, const Edition& edition) const {
  const Known& publication = known(stored);
  const auto generation = std::to_underlying(edition.generation);
  return {stored.entry, audience(publication), publication.classes[generation],
          publication.signatures[generation].get()};
}

}  // namespace geminga::matching
