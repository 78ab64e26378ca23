// The semantic index: entries by the class that they are filed under and by every class that they are filed below.
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

/// A class that nobody is filed under costs one pointer, because an ontology has many more classes than a team
/// services.
template <typename Entry>
class SemanticIndex {
 public:
  /// Requires that nothing is filed.
  void set_class_count(std::size_t count) {
    for (const auto& buckets : classes_) {
      GEMINGA_ASSERT(!buckets || (buckets->own.is_empty() && buckets->below.is_empty()));
    }
    classes_.clear();
    classes_.resize(count);
    classes_.shrink_to_fit();
  }

  void file(const Stored<Entry>& stored, const Filing& filing) {
    const FiledBy by = filed_by(filing.generation);
    if (filing.own) at(*filing.own).own.file(stored, by);
    for (const ClassIndex number : filing.further_own) at(number).own.file(stored, by);
    for (const ClassIndex number : filing.below) at(number).below.file(stored, by);
  }

  [[nodiscard]] std::span<const Filed<Entry>> own(ClassIndex number) const {
    return number < classes_.size() && classes_[number] ? classes_[number]->own.entries() : none();
  }
  [[nodiscard]] std::span<const Filed<Entry>> below(ClassIndex number) const {
    return number < classes_.size() && classes_[number] ? classes_[number]->below.entries() : none();
  }

 private:
  struct Buckets {
    Bucket<Entry> own;
    Bucket<Entry> below;
  };

  static std::span<const Filed<Entry>> none() { return {}; }

  Buckets& at(ClassIndex number) {
    GEMINGA_ASSERT(number < classes_.size());
    auto& buckets = classes_[number];
    if (!buckets) buckets = std::make_unique<Buckets>();
    return *buckets;
  }

  std::vector<std::unique_ptr<Buckets>> classes_;
};

}  // namespace geminga::registry

#endif
