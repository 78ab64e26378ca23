// The index of entries by the classes that they are filed under and those that they are filed below.
#ifndef GEMINGA_DISCOVERY_REGISTRY_SEMANTIC_INDEX_HPP
#define GEMINGA_DISCOVERY_REGISTRY_SEMANTIC_INDEX_HPP

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "base/assert.hpp"
#include "discovery/registry/stored.hpp"
#include "discovery/registry/table.hpp"

namespace geminga::registry {

/// A class without entries costs one pointer, because an ontology has many more classes than a team has services.
template <typename Entry>
class SemanticIndex {
 public:
  /// Requires that nothing is filed.
  void set_class_count(std::size_t count) {
    for (const auto& buckets : classes_) {
      GEMINGA_ASSERT(!buckets || (buckets->own.is_empty() && buckets->below.is_empty()));
    }
    GEMINGA_ASSERT(count <= max_classes);
    classes_.clear();
    classes_.resize(count);
    classes_.shrink_to_fit();
  }

  void file(const Stored<Entry>& stored, const Filing& filing) {
    auto& filings = filings_of(stored, filing.generation);
    filings.reserve(filing.below.size() + filing.further_own.size() + (filing.own ? 1 : 0));
    const auto file_in = [&](ClassIndex number, bool is_below) {
      ClassedAt filed{2 * number + (is_below ? 1 : 0)};
      filed.position = at(filed).file(stored, filed_by(filing.generation), filings.size());
      filings.push_back(filed);
    };
    if (filing.own) file_in(*filing.own, false);
    for (const ClassIndex number : filing.further_own) file_in(number, false);
    for (const ClassIndex number : filing.below) file_in(number, true);
  }

  /// Takes an entry out. O(filings).
  void unfile(const Stored<Entry>& stored, Generation generation) {
    auto& filings = filings_of(stored, generation);
    for (; !filings.empty(); filings.pop_back()) at(filings.back()).remove(filings.back().position);
  }

  [[nodiscard]] std::span<const Filed<Entry>> own(ClassIndex number) const {
    return number < classes_.size() && classes_[number] ? classes_[number]->own.entries() : none();
  }
  [[nodiscard]] std::span<const Filed<Entry>> below(ClassIndex number) const {
    return number < classes_.size() && classes_[number] ? classes_[number]->below.entries() : none();
  }

 private:
  static constexpr std::size_t max_classes = std::size_t{1} << 31;  ///< more than any vocabulary has

  struct Buckets {
    Bucket<Entry> own;
    Bucket<Entry> below;
  };

  static std::span<const Filed<Entry>> none() { return {}; }

  static std::vector<ClassedAt>& filings_of(const Stored<Entry>& stored, Generation generation) {
    return stored.classes[std::to_underlying(generation)];
  }

  /// The bucket of entries filed under a class, or that of entries filed below it.
  Bucket<Entry>& at(const ClassedAt& filed) {
    GEMINGA_ASSERT(filed.number() < classes_.size());
    auto& buckets = classes_[filed.number()];
    if (!buckets) buckets = std::make_unique<Buckets>();
    return filed.is_below() ? buckets->below : buckets->own;
  }

  std::vector<std::unique_ptr<Buckets>> classes_;
};

}  // namespace geminga::registry

#endif
