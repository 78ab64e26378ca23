// The ontology as the daemon sees it, over the compiled form in place.
#include "reasoning/compiled/ontology.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

#include "base/sorted.hpp"
#include "base/text.hpp"
#include "reasoning/compiled/compiled_view.hpp"
#include "reasoning/compiled/container.hpp"
#include "reasoning/compiled/container_header.hpp"
#include "reasoning/compiled/entity_names.hpp"
#include "reasoning/compiled/mapped_file.hpp"
#include "reasoning/compiled/similar.hpp"
#include "reasoning/modules/module.hpp"
#include "reasoning/owl/fingerprint.hpp"
#include "reasoning/owl/left_out.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/owl/print.hpp"
#include "reasoning/owl/source_paths.hpp"

namespace geminga::compiled {

struct Ontology::Mapped {
  MappedFile mapping;  ///< one of these two owns the bytes
  std::vector<std::byte> bytes;
  std::string folder;  ///< that paths of files are relative to
  Container file;
  TaxonomySection taxonomy;
  std::vector<std::pair<std::string_view, std::string_view>> prefixes;  ///< sorted

  // Verified when it is first asked for.
  mutable std::once_flag labels_once;
  mutable LabelsView labels;
  mutable std::optional<CompiledError> labels_error;
  mutable std::once_flag axioms_once;
  mutable taxonomy::ClassifiedView whole;
  mutable std::optional<CompiledError> axioms_error;

  [[nodiscard]] std::expected<std::unique_ptr<const Mapped>, CompiledError> static finish(
      std::unique_ptr<Mapped> mapped, std::span<const std::byte> all);
  [[nodiscard]] std::uint32_t node(taxonomy::ClassNumber number) const {
    return taxonomy.view.representative[static_cast<std::size_t>(number)];
  }
  [[nodiscard]] bool is_unsatisfiable(std::uint32_t node) const {
    return node == taxonomy.view.representative[taxonomy.view.nothing];
  }
  [[nodiscard]] const LabelsView& need_labels() const;
  [[nodiscard]] const taxonomy::ClassifiedView& need_axioms() const;
  [[nodiscard]] std::optional<std::uint32_t> find_class(std::string_view iri) const;
  [[nodiscard]] std::vector<std::uint32_t> find_label(std::string_view label) const;
  [[nodiscard]] std::vector<std::uint32_t> walk_up(std::uint32_t node) const;
  void add_members(std::uint32_t node, std::vector<taxonomy::ClassNumber>& classes) const;
};

namespace {

std::vector<taxonomy::ClassNumber> to_classes(std::span<const std::uint32_t> numbers) {
  std::vector<taxonomy::ClassNumber> classes;
  classes.reserve(numbers.size());
  for (const std::uint32_t number : numbers) classes.push_back(taxonomy::ClassNumber{number});
  return classes;
}

std::unexpected<NameError> name_error(NameError::Kind kind, std::string text) {
  return std::unexpected(NameError{kind, std::move(text)});
}

std::expected<void, std::string> looks_compiled(std::span<const std::byte> beginning, std::uint64_t size) {
  static_assert(MappedFile::beginning_bytes == container_header_bytes);
  if (auto looked = check_header(beginning, size); !looked) return std::unexpected(looked.error().text);
  return {};
}

/// The first of `count` ascending pieces that is not less than `wanted`.
template <typename Piece>
std::uint32_t lower_bound(std::uint32_t count, std::string_view wanted, Piece&& piece) {
  std::uint32_t first = 0;
  while (count > 0) {
    const std::uint32_t half = count / 2;
    if (piece(first + half) < wanted) {
      first += half + 1;
      count -= half + 1;
    } else {
      count = half;
    }
  }
  return first;
}

}  // namespace

std::expected<std::unique_ptr<const Ontology::Mapped>, CompiledError> Ontology::Mapped::finish(
    std::unique_ptr<Mapped> mapped, std::span<const std::byte> all) {
  auto file = Container::open(all);
  if (!file) return std::unexpected(file.error());
  auto taxonomy = view_taxonomy(*file);
  if (!taxonomy) return std::unexpected(taxonomy.error());
  mapped->file = *file;
  mapped->taxonomy = *taxonomy;
  mapped->prefixes = prefixes_of(*taxonomy);
  return mapped;
}

const LabelsView& Ontology::Mapped::need_labels() const {
  std::call_once(labels_once, [this] {
    if (auto found = view_labels(file, taxonomy.view)) {
      labels = *found;
    } else {
      labels_error = std::move(found.error());
    }
  });
  return labels;
}

const taxonomy::ClassifiedView& Ontology::Mapped::need_axioms() const {
  std::call_once(axioms_once, [this] {
    if (auto found = view_axioms(file, taxonomy)) {
      whole = *found;
    } else {
      whole = taxonomy.view;
      axioms_error = std::move(found.error());
    }
  });
  return whole;
}

std::optional<std::uint32_t> Ontology::Mapped::find_class(std::string_view iri) const {
  const std::uint32_t count = taxonomy.view.class_count();
  const std::uint32_t at =
      lower_bound(count, iri, [&](std::uint32_t number) { return taxonomy.view.class_iri(number); });
  if (at == count || taxonomy.view.class_iri(at) != iri) return std::nullopt;
  return at;
}

std::vector<std::uint32_t> Ontology::Mapped::find_label(std::string_view label) const {
  const LabelsView& all = need_labels();
  const std::uint32_t at = lower_bound(all.count(), label, [&](std::uint32_t number) { return all.label(number); });
  if (at == all.count() || all.label(at) != label) return {};
  const auto found = taxonomy::ClassifiedView::row(all.class_begin, all.classes, at);
  std::vector<std::uint32_t> classes(found.begin(), found.end());
  base::sort_unique(classes);
  return classes;
}

std::vector<std::uint32_t> Ontology::Mapped::walk_up(std::uint32_t node) const {
  std::vector<std::uint32_t> above;
  above.reserve(16);
  // Most classes have one parent, up to the top. A taxonomy that lies goes round in a circle.
  std::span<const std::uint32_t> only = std::span(&node, 1);
  while (only.size() == 1 && above.size() < taxonomy.view.class_count()) {
    above.push_back(only.front());
    only = taxonomy.view.parents_of(above.back());
  }
  std::vector<std::uint32_t> layer;
  if (!only.empty()) layer.push_back(above.back());
  base::sort_unique(above);
  while (!layer.empty()) {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t at : layer) {
      const auto parents = taxonomy.view.parents_of(at);
      next.insert(next.end(), parents.begin(), parents.end());
    }
    base::sort_unique(next);
    std::erase_if(next, [&](std::uint32_t at) { return std::ranges::binary_search(above, at); });
    std::vector<std::uint32_t> both;
    both.reserve(above.size() + next.size());
    std::ranges::merge(above, next, std::back_inserter(both));
    above = std::move(both);
    layer = std::move(next);
  }
  return above;
}

void Ontology::Mapped::add_members(std::uint32_t node, std::vector<taxonomy::ClassNumber>& classes) const {
  classes.push_back(taxonomy::ClassNumber{node});
  for (auto member = std::ranges::lower_bound(taxonomy.view.members, taxonomy::EquivalentMember{node, 0});
       member != taxonomy.view.members.end() && member->node == node; ++member) {
    classes.push_back(taxonomy::ClassNumber{member->other});
  }
}

std::expected<Ontology, CompiledError> Ontology::map(const std::string& path) {
  auto file = MappedFile::copy_of(path, looks_compiled);
  if (!file) return std::unexpected(CompiledError{file.error()});
  auto mapped = std::make_unique<Mapped>();
  mapped->mapping = std::move(*file);
  mapped->folder = owl::folder_of(path);
  const std::span<const std::byte> all = mapped->mapping.bytes();
  auto finished = Mapped::finish(std::move(mapped), all);
  if (!finished) return std::unexpected(CompiledError{path + ": " + finished.error().text});
  return Ontology(std::move(*finished));
}

std::expected<Ontology, CompiledError> Ontology::from_bytes(std::vector<std::byte> bytes) {
  auto mapped = std::make_unique<Mapped>();
  mapped->bytes = std::move(bytes);
  const std::span<const std::byte> all = mapped->bytes;
  auto finished = Mapped::finish(std::move(mapped), all);
  if (!finished) return std::unexpected(finished.error());
  return Ontology(std::move(*finished));
}

Ontology::Ontology(std::unique_ptr<const Mapped> mapped)
    : mapped_(std::move(mapped)),
      reach_(mapped_->taxonomy.view.reach.data()),
      further_(mapped_->taxonomy.view.further.data()) {}
Ontology::Ontology(Ontology&&) noexcept = default;
Ontology& Ontology::operator=(Ontology&&) noexcept = default;
Ontology::~Ontology() = default;

std::expected<void, CompiledError> Ontology::check_labels() const {
  (void)mapped_->need_labels();
  if (mapped_->labels_error) return std::unexpected(*mapped_->labels_error);
  return {};
}

std::expected<void, CompiledError> Ontology::check_axioms() const {
  (void)mapped_->need_axioms();
  if (mapped_->axioms_error) return std::unexpected(*mapped_->axioms_error);
  return {};
}

std::expected<void, CompiledError> Ontology::check_whole() const {
  if (auto labels = check_labels(); !labels) return labels;
  return check_axioms();
}

std::uint64_t Ontology::digest() const { return mapped_->taxonomy.view.digest; }
std::uint32_t Ontology::class_count() const { return mapped_->taxonomy.view.class_count(); }
std::vector<std::string> Ontology::gaps() const { return gaps_of(mapped_->taxonomy); }
std::size_t Ontology::axiom_count() const { return counted_axioms(mapped_->taxonomy); }
std::span<const std::pair<std::string_view, std::string_view>> Ontology::prefixes() const { return mapped_->prefixes; }
std::span<const std::uint64_t> Ontology::signatures() const { return signatures_of(mapped_->taxonomy); }
bool Ontology::is_consistent() const { return mapped_->taxonomy.view.is_consistent; }

std::vector<owl::LoadedFile> Ontology::files() const {
  std::vector<owl::LoadedFile> files = files_of(mapped_->taxonomy);
  for (owl::LoadedFile& file : files) file.path = owl::seen_from_here(mapped_->folder, file.path);
  return files;
}

std::vector<owl::LeftOut> Ontology::placed(std::vector<owl::LeftOut> left_out) const {
  const std::vector<owl::LoadedFile> known = files();
  for (owl::LeftOut& one : left_out) {
    if (one.file < known.size()) one.first = known[one.file].path + ':' + std::to_string(one.line);
  }
  return left_out;
}

std::vector<owl::LeftOut> Ontology::left_out() const { return placed(left_out_of(mapped_->taxonomy)); }

std::optional<std::string> Ontology::stale_source() const {
  for (const owl::LoadedFile& file : files()) {
    if (!has_changed(file.path, file.content)) continue;
    return base::printable(file.path, 4096) + " has changed since this was compiled: compile it again";
  }
  return std::nullopt;
}

std::optional<taxonomy::ClassNumber> Ontology::find_iri(std::string_view iri) const {
  if (const auto found = mapped_->find_class(iri)) return taxonomy::ClassNumber{*found};
  return std::nullopt;
}

std::expected<taxonomy::ClassNumber, NameError> Ontology::find(std::string_view name) const {
  using Kind = NameError::Kind;
  const std::string shown = base::printable(name);
  if (name.empty()) return name_error(Kind::malformed, "the name is empty: give prefix:Name, <IRI> or a label");
  if (name.front() == '<') {
    if (name.size() < 3 || name.back() != '>') {
      return name_error(Kind::malformed, "'" + shown + "' opens with < and does not end in >");
    }
    if (const auto found = find_iri(name.substr(1, name.size() - 2))) return *found;
    return name_error(Kind::unknown, "no class has the IRI " + shown);
  }
  // All meanings are looked for, so that an ambiguous name is reported as such.
  std::vector<std::uint32_t> found;
  bool has_known_prefix = false;
  const std::size_t colon = name.find(':');
  if (colon != std::string_view::npos) {
    const std::string_view word = name.substr(0, colon);
    for (auto prefix = std::ranges::lower_bound(mapped_->prefixes, word, {}, [](const auto& p) { return p.first; });
         prefix != mapped_->prefixes.end() && prefix->first == word; ++prefix) {
      has_known_prefix = true;
      const std::string iri = std::string(prefix->second) + std::string(name.substr(colon + 1));
      if (const auto number = mapped_->find_class(iri)) found.push_back(*number);
    }
    if (const auto number = mapped_->find_class(name); number && found.empty()) found.push_back(*number);
  }
  if (found.empty()) found = mapped_->find_label(name);
  if (found.empty()) found = classes_with_local_name(*this, name);
  base::sort_unique(found);
  if (found.size() == 1) return taxonomy::ClassNumber{found.front()};
  if (found.size() > 1) {
    std::vector<std::string> names;
    for (const std::uint32_t number : found) names.push_back(short_name(taxonomy::ClassNumber{number}));
    return name_error(Kind::ambiguous, "'" + shown + "' may be " + alternatives(names) + ": say which");
  }
  if (colon != std::string_view::npos && !has_known_prefix && name.find("//") == std::string_view::npos) {
    std::string known;
    for (const auto& [word, iri] : mapped_->prefixes) {
      if (!word.empty() && known.find(std::string(word) + ":") == std::string::npos) {
        known += (known.empty() ? "" : " ") + std::string(word) + ":";
      }
    }
    return name_error(Kind::unknown, "'" + shown + "' has an unknown prefix: known are " + base::printable(known, 200));
  }
  if (const auto whole = check_labels(); !whole) {
    return name_error(Kind::unknown, "no class is '" + shown + "', and labels cannot be read: " + whole.error().text);
  }
  return name_error(Kind::unknown, "'" + shown + "' is neither a class nor a label");
}

std::string_view Ontology::iri(taxonomy::ClassNumber number) const {
  return mapped_->taxonomy.view.class_iri(static_cast<std::uint32_t>(number));
}

std::string_view Ontology::label(taxonomy::ClassNumber number) const {
  const LabelsView& labels = mapped_->need_labels();
  const auto at = static_cast<std::size_t>(number);
  if (at >= labels.label_of_class.size() || labels.label_of_class[at] == taxonomy::ClassifiedView::none) return {};
  return labels.label(labels.label_of_class[at]);
}

std::string Ontology::short_name(taxonomy::ClassNumber number) const { return short_name(iri(number)); }
std::string Ontology::short_name(std::string_view iri) const { return owl::shorten(iri, mapped_->prefixes); }

bool Ontology::is_satisfiable(taxonomy::ClassNumber number) const {
  return !mapped_->is_unsatisfiable(mapped_->node(number));
}

std::optional<std::uint32_t> Ontology::distance(taxonomy::ClassNumber sub, taxonomy::ClassNumber super) const {
  if (!is_subsumed(sub, super)) return std::nullopt;
  const std::uint32_t from = mapped_->node(sub);
  const std::uint32_t to = mapped_->node(super);
  if (from == to) return 0;
  // An unsatisfiable class lies below every leaf, so its path is searched from above.
  const bool is_down = mapped_->is_unsatisfiable(from);
  std::vector<std::uint32_t> layer = {is_down ? to : from};
  for (std::uint32_t distance = 1;; ++distance) {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t node : layer) {
      const auto neighbours =
          is_down ? mapped_->taxonomy.view.children_of(node) : mapped_->taxonomy.view.parents_of(node);
      if (is_down && neighbours.empty()) return distance;
      for (const std::uint32_t neighbour : neighbours) {
        if (neighbour == to) return distance;
        // Only classes below the goal can lead to it.
        if (is_down || is_subsumed(taxonomy::ClassNumber{neighbour}, super)) next.push_back(neighbour);
      }
    }
    base::sort_unique(next);
    if (next.empty() || distance > class_count()) return std::nullopt;
    layer = std::move(next);
  }
}

std::vector<taxonomy::ClassNumber> Ontology::subsumers(taxonomy::ClassNumber number) const {
  std::vector<taxonomy::ClassNumber> classes;
  if (!is_satisfiable(number)) {
    for (std::uint32_t other = 0; other < class_count(); ++other) classes.push_back(taxonomy::ClassNumber{other});
    return classes;
  }
  for (const std::uint32_t node : mapped_->walk_up(mapped_->node(number))) mapped_->add_members(node, classes);
  std::ranges::sort(classes);
  return classes;
}

std::vector<taxonomy::ClassNumber> Ontology::parents(taxonomy::ClassNumber number) const {
  return to_classes(mapped_->taxonomy.view.parents_of(mapped_->node(number)));
}

std::vector<taxonomy::ClassNumber> Ontology::children(taxonomy::ClassNumber number) const {
  return to_classes(mapped_->taxonomy.view.children_of(mapped_->node(number)));
}

UnitsView Ontology::units() const { return units_of(mapped_->taxonomy); }
std::vector<owl::LeftOut> Ontology::units_left_out() const { return placed(units_left_out_of(mapped_->taxonomy)); }
std::span<const taxonomy::Conversion> Ontology::conversions() const { return conversions_of(mapped_->taxonomy); }

const taxonomy::ClassifiedView& Ontology::view() const { return mapped_->taxonomy.view; }
const taxonomy::ClassifiedView& Ontology::axioms() const { return mapped_->need_axioms(); }
modules::ModuleIndex Ontology::module_index() const { return modules::ModuleIndex(axioms()); }

}  // namespace geminga::compiled
