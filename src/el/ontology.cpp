// The ontology as the daemon sees it, over the compiled form in place.
#include "el/ontology.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

#include "base/text.hpp"
#include "el/compiled_view.hpp"
#include "el/mapped_file.hpp"
#include "el/module.hpp"
#include "el/print.hpp"

namespace geminga::el {

namespace {

/// What "is A under B" needs of a class, in one place: two of these are a question's two misses of the cache, where the
/// tables of the compiled form would cost five.
struct Reach {
  static constexpr std::uint32_t of_nothing = 0xffffffff;
  std::uint32_t first = of_nothing;  ///< its rank; of_nothing where it has no instances
  std::uint32_t last = 0;
  std::uint32_t further_begin = 0;
  std::uint32_t further_end = 0;
};

}  // namespace

struct Ontology::Mapped {
  MappedFile file;  ///< one of these two owns the bytes
  std::vector<std::byte> bytes;
  CompiledView view;
  std::vector<std::pair<std::string_view, std::string_view>> prefixes;  ///< sorted
  std::vector<std::pair<std::uint32_t, std::uint32_t>> equivalents;     ///< representative, another member; sorted
  std::vector<Reach> reaches;                                           ///< by class
  mutable std::once_flag module_index_once;
  mutable std::optional<ModuleIndex> module_index;

  [[nodiscard]] std::expected<std::unique_ptr<const Mapped>, CompiledError> static finish(
      std::unique_ptr<Mapped> mapped, std::span<const std::byte> all);
  [[nodiscard]] std::uint32_t node(ClassNumber number) const {
    return view.representative[static_cast<std::size_t>(number)];
  }
  [[nodiscard]] bool is_unsatisfiable(std::uint32_t node) const { return node == view.representative[view.nothing]; }
  [[nodiscard]] std::optional<std::uint32_t> find_class(std::string_view iri) const;
  [[nodiscard]] std::vector<std::uint32_t> find_label(std::string_view label) const;
  [[nodiscard]] std::vector<std::uint32_t> walk_up(std::uint32_t node) const;
  void add_members(std::uint32_t node, std::vector<ClassNumber>& classes) const;
};

namespace {

std::vector<ClassNumber> to_classes(std::span<const std::uint32_t> numbers) {
  std::vector<ClassNumber> classes;
  classes.reserve(numbers.size());
  for (const std::uint32_t number : numbers) classes.push_back(ClassNumber{number});
  return classes;
}

std::unexpected<NameError> name_error(NameError::Kind kind, std::string text) {
  return std::unexpected(NameError{kind, std::move(text)});
}

}  // namespace

std::expected<std::unique_ptr<const Ontology::Mapped>, CompiledError> Ontology::Mapped::finish(
    std::unique_ptr<Mapped> mapped, std::span<const std::byte> all) {
  auto view = view_compiled(all);
  if (!view) return std::unexpected(view.error());
  mapped->view = *view;
  for (std::size_t at = 0; at < view->prefix_name.size(); ++at) {
    mapped->prefixes.emplace_back(view->name(view->prefix_name[at]), view->name(view->prefix_iri[at]));
  }
  std::ranges::sort(mapped->prefixes);
  mapped->reaches.resize(view->class_count());
  for (std::uint32_t number = 0; number < view->class_count(); ++number) {
    const std::uint32_t node = view->representative[number];
    if (!mapped->is_unsatisfiable(node)) {
      const Interval own = view->own_interval[number];
      mapped->reaches[number] = {own.first, own.last, view->further_begin[node], view->further_begin[node + 1]};
    }
    if (view->representative[number] != number) mapped->equivalents.emplace_back(view->representative[number], number);
  }
  std::ranges::sort(mapped->equivalents);
  return mapped;
}

std::optional<std::uint32_t> Ontology::Mapped::find_class(std::string_view iri) const {
  const auto name_of = [&](std::uint32_t name) { return view.name(name); };
  const auto found = std::ranges::lower_bound(view.class_name, iri, {}, name_of);
  if (found == view.class_name.end() || name_of(*found) != iri) return std::nullopt;
  return static_cast<std::uint32_t>(found - view.class_name.begin());
}

std::vector<std::uint32_t> Ontology::Mapped::find_label(std::string_view label) const {
  const auto [first, last] =
      std::ranges::equal_range(view.label_text, label, {}, [&](std::uint32_t name) { return view.name(name); });
  const auto begin = static_cast<std::size_t>(first - view.label_text.begin());
  const auto found = view.label_class.subspan(begin, static_cast<std::size_t>(last - first));
  std::vector<std::uint32_t> classes(found.begin(), found.end());
  std::ranges::sort(classes);
  classes.erase(std::unique(classes.begin(), classes.end()), classes.end());
  return classes;
}

std::vector<std::uint32_t> Ontology::Mapped::walk_up(std::uint32_t node) const {
  std::vector<std::uint32_t> above = {node};
  std::vector<std::uint32_t> layer = above;
  while (!layer.empty()) {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t at : layer) {
      const auto parents = view.parents_of(at);
      next.insert(next.end(), parents.begin(), parents.end());
    }
    std::ranges::sort(next);
    next.erase(std::unique(next.begin(), next.end()), next.end());
    std::erase_if(next, [&](std::uint32_t at) { return std::ranges::binary_search(above, at); });
    std::vector<std::uint32_t> both;
    both.reserve(above.size() + next.size());
    std::ranges::merge(above, next, std::back_inserter(both));
    above = std::move(both);
    layer = std::move(next);
  }
  return above;
}

void Ontology::Mapped::add_members(std::uint32_t node, std::vector<ClassNumber>& classes) const {
  classes.push_back(ClassNumber{node});
  for (auto member = std::ranges::lower_bound(equivalents, std::pair(node, 0U));
       member != equivalents.end() && member->first == node; ++member) {
    classes.push_back(ClassNumber{member->second});
  }
}

std::expected<Ontology, CompiledError> Ontology::map(const std::string& path) {
  auto file = MappedFile::open(path);
  if (!file) return std::unexpected(CompiledError{file.error()});
  auto mapped = std::make_unique<Mapped>();
  mapped->file = std::move(*file);
  const std::span<const std::byte> all = mapped->file.bytes();
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

Ontology::Ontology(std::unique_ptr<const Mapped> mapped) : mapped_(std::move(mapped)) {}
Ontology::Ontology(Ontology&&) noexcept = default;
Ontology& Ontology::operator=(Ontology&&) noexcept = default;
Ontology::~Ontology() = default;

std::uint64_t Ontology::digest() const { return mapped_->view.digest; }
std::uint32_t Ontology::class_count() const { return mapped_->view.class_count(); }
std::vector<LoadedFile> Ontology::files() const { return files_of(mapped_->view); }
std::optional<std::string> Ontology::stale_source() const {
  for (const LoadedFile& file : files()) {
    if (!has_changed(file.path, file.content)) continue;
    return base::printable(file.path, 4096) + " has changed since this was compiled: compile it again";
  }
  return std::nullopt;
}

std::vector<LeftOut> Ontology::left_out() const { return left_out_of(mapped_->view); }
bool Ontology::is_consistent() const { return mapped_->view.is_consistent; }

std::optional<ClassNumber> Ontology::find_iri(std::string_view iri) const {
  if (const auto found = mapped_->find_class(iri)) return ClassNumber{*found};
  return std::nullopt;
}

std::expected<ClassNumber, NameError> Ontology::find(std::string_view name) const {
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
  // Whatever fits is looked for, so that a name with two meanings is said to have them.
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
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  if (found.size() == 1) return ClassNumber{found.front()};
  if (found.size() > 1) {
    return name_error(Kind::ambiguous, "'" + shown + "' may be " + short_name(ClassNumber{found[0]}) + " or " +
                                           short_name(ClassNumber{found[1]}) + (found.size() > 2 ? " or another" : "") +
                                           ": say which");
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
  return name_error(Kind::unknown, "no class and no label is '" + shown + "'");
}

std::string_view Ontology::iri(ClassNumber number) const {
  return mapped_->view.name(mapped_->view.class_name[static_cast<std::size_t>(number)]);
}

std::string_view Ontology::label(ClassNumber number) const {
  const std::uint32_t name = mapped_->view.class_label[static_cast<std::size_t>(number)];
  return name == CompiledView::none ? std::string_view() : mapped_->view.name(name);
}

std::string Ontology::short_name(ClassNumber number) const { return short_name(iri(number)); }
std::string Ontology::short_name(std::string_view iri) const { return shorten(iri, mapped_->prefixes); }

bool Ontology::is_satisfiable(ClassNumber number) const { return !mapped_->is_unsatisfiable(mapped_->node(number)); }

bool Ontology::is_subsumed(ClassNumber sub, ClassNumber super) const {
  const std::uint32_t rank = mapped_->reaches[static_cast<std::size_t>(sub)].first;
  const Reach& reach = mapped_->reaches[static_cast<std::size_t>(super)];
  if ((reach.first <= rank && rank <= reach.last) || rank == Reach::of_nothing) return true;
  if (reach.further_begin == reach.further_end) return false;
  return contains_rank(mapped_->view.further.subspan(reach.further_begin, reach.further_end - reach.further_begin),
                       rank);
}

std::optional<std::uint32_t> Ontology::distance(ClassNumber sub, ClassNumber super) const {
  if (!is_subsumed(sub, super)) return std::nullopt;
  const std::uint32_t from = mapped_->node(sub);
  const std::uint32_t to = mapped_->node(super);
  if (from == to) return 0;
  // What is unsatisfiable lies below every leaf: the way is sought from above.
  const bool is_down = mapped_->is_unsatisfiable(from);
  std::vector<std::uint32_t> layer = {is_down ? to : from};
  for (std::uint32_t distance = 1;; ++distance) {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t node : layer) {
      const auto neighbours = is_down ? mapped_->view.children_of(node) : mapped_->view.parents_of(node);
      if (is_down && neighbours.empty()) return distance;
      for (const std::uint32_t neighbour : neighbours) {
        if (neighbour == to) return distance;
        // Only what is still below the goal can lead to it.
        if (is_down || is_subsumed(ClassNumber{neighbour}, super)) next.push_back(neighbour);
      }
    }
    std::ranges::sort(next);
    next.erase(std::unique(next.begin(), next.end()), next.end());
    if (next.empty() || distance > class_count()) return std::nullopt;
    layer = std::move(next);
  }
}

std::vector<ClassNumber> Ontology::subsumers(ClassNumber number) const {
  std::vector<ClassNumber> classes;
  if (!is_satisfiable(number)) {
    for (std::uint32_t other = 0; other < class_count(); ++other) classes.push_back(ClassNumber{other});
    return classes;
  }
  for (const std::uint32_t node : mapped_->walk_up(mapped_->node(number))) mapped_->add_members(node, classes);
  std::ranges::sort(classes);
  return classes;
}

std::vector<ClassNumber> Ontology::parents(ClassNumber number) const {
  return to_classes(mapped_->view.parents_of(mapped_->node(number)));
}

std::vector<ClassNumber> Ontology::children(ClassNumber number) const {
  return to_classes(mapped_->view.children_of(mapped_->node(number)));
}

const CompiledView& Ontology::view() const { return mapped_->view; }

const ModuleIndex& Ontology::module_index() const {
  std::call_once(mapped_->module_index_once, [this] { mapped_->module_index.emplace(mapped_->view); });
  return *mapped_->module_index;
}

}  // namespace geminga::el
