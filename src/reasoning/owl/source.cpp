// Interning of names and terms, and the limits of what one ontology may hold.
#include "reasoning/owl/source.hpp"

#include <algorithm>
#include <array>
#include <ranges>
#include <set>
#include <utility>

#include "base/assert.hpp"
#include "base/hash.hpp"
#include "base/text.hpp"
#include "reasoning/owl/datatypes.hpp"
#include "reasoning/owl/literal_value.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/owl/unit.hpp"

namespace geminga::owl {
namespace {

constexpr std::string_view xsd_string = "http://www.w3.org/2001/XMLSchema#string";
constexpr std::string_view rdf_lang_string = "http://www.w3.org/1999/02/22-rdf-syntax-ns#langString";

/// The octets that all names together may take: this many, and as many again for each different name as names usually
/// have. Published names are 20 to 100 octets long, and texts of facts some hundreds, so that only what is made to fill
/// the memory is refused.
constexpr std::size_t always_named = std::size_t{16} << 20U;
constexpr std::size_t named_per_name = 256;
constexpr std::size_t named_per_literal = 4096;

std::uint64_t hash_of_term(TermKind kind, NameId name, std::uint32_t number, std::span<const TermId> arguments) {
  std::uint64_t hash = base::mixed(static_cast<std::uint64_t>(kind) << 32 | number, static_cast<std::uint32_t>(name));
  for (const TermId argument : arguments) hash = base::mixed(hash, static_cast<std::uint32_t>(argument));
  return base::mixed(hash, arguments.size());
}

}  // namespace

Ontology::Ontology(const SourceLimits& limits) : limits_(limits) {
  // The empty name and the first two terms are always there, whatever the limits.
  intern("", 0);
  intern_term(TermKind::named_class, intern(owl_thing, owl_thing.size()), 0, {});
  intern_term(TermKind::named_class, intern(owl_nothing, owl_nothing.size()), 0, {});
  // Every taxonomy of properties has these.
  for (const std::string_view property :
       {owl_top_object_property, owl_bottom_object_property, owl_top_data_property, owl_bottom_data_property}) {
    intern(property, property.size());
  }
  problem_.reset();
}

Ontology::Ontology(const Ontology&) = default;
Ontology::Ontology(Ontology&&) noexcept = default;
Ontology& Ontology::operator=(const Ontology&) = default;
Ontology& Ontology::operator=(Ontology&&) noexcept = default;
Ontology::~Ontology() = default;

std::span<const LoadedFile> Ontology::files() const { return files_; }

void Ontology::fail(std::string text) {
  if (!problem_) problem_ = std::move(text);
}

std::span<const TermKind> Ontology::kinds_of(std::span<const TermId> arguments) {
  kinds_.clear();
  for (const TermId argument : arguments) kinds_.push_back(kind(argument));
  return kinds_;
}

NameId Ontology::intern(std::string_view name, std::size_t max_bytes) {
  if (name.size() > max_bytes) {
    fail("a name or literal of " + std::to_string(name.size()) + " bytes is over the limit of " +
         std::to_string(max_bytes));
    return NameId{0};
  }
  const std::uint64_t hash = base::hash64(name);
  const std::uint32_t found =
      name_table_.find(hash, [&](std::uint32_t number) { return this->name(NameId{number}) == name; });
  if (found != base::NumberTable::none) return NameId{found};
  const std::size_t each = max_bytes == limits_.literal_bytes ? named_per_literal : named_per_name;
  const std::size_t most = std::min(limits_.all_name_bytes, always_named + each * name_ends_.size());
  if (name_bytes_.size() + name.size() > most) {
    fail("the names are over the limit of " + std::to_string(most) + " bytes together");
    return NameId{0};
  }
  const auto number = static_cast<std::uint32_t>(name_ends_.size());
  name_bytes_.insert(name_bytes_.end(), name.begin(), name.end());
  name_ends_.push_back(static_cast<std::uint32_t>(name_bytes_.size()));
  name_table_.insert(hash, number);
  entity_of_name_.push_back(base::NumberTable::none);
  return NameId{number};
}

std::string_view Ontology::name(NameId id) const {
  const auto index = static_cast<std::size_t>(id);
  const std::size_t begin = index == 0 ? 0 : name_ends_[index - 1];
  return {name_bytes_.data() + begin, name_ends_[index] - begin};
}

std::string Ontology::unused_name(std::string_view name) const {
  std::string unused(name);
  while (find_name(unused)) unused += '-';
  return unused;
}

std::optional<NameId> Ontology::find_name(std::string_view name) const {
  const std::uint32_t found =
      name_table_.find(base::hash64(name), [&](std::uint32_t number) { return this->name(NameId{number}) == name; });
  if (found == base::NumberTable::none) return std::nullopt;
  return NameId{found};
}

Term Ontology::term(TermId id) const {
  const TermRecord& record = terms_[static_cast<std::size_t>(id)];
  return {record.kind, record.name, record.number, std::span(term_arguments_).subspan(record.begin, record.count)};
}

TermId Ontology::intern_term(TermKind kind, NameId name, std::uint32_t number, std::span<const TermId> arguments) {
  const std::uint64_t hash = hash_of_term(kind, name, number, arguments);
  const std::uint32_t found = term_table_.find(hash, [&](std::uint32_t candidate) {
    const Term filed = term(TermId{candidate});
    return filed.kind == kind && filed.name == name && filed.number == number &&
           std::ranges::equal(filed.arguments, arguments);
  });
  if (found != base::NumberTable::none) return TermId{found};
  if (terms_.size() >= limits_.terms || term_arguments_.size() + arguments.size() > limits_.arguments) {
    fail("the ontology has more than " + std::to_string(limits_.terms) + " different terms or " +
         std::to_string(limits_.arguments) + " arguments");
    if (terms_.size() > 1) return thing_term;  // some valid term must come back
  }
  std::uint32_t depth = 0;
  Form form = own_form(kind, name, arguments);
  for (const TermId argument : arguments) {
    const TermRecord& record = terms_[static_cast<std::size_t>(argument)];
    depth = std::max(depth, record.depth + 1U);
    form = std::max(form, record.form);
  }
  const auto id = static_cast<std::uint32_t>(terms_.size());
  terms_.push_back({kind, form, static_cast<std::uint16_t>(std::min(depth, 0xffffU)), name, number,
                    static_cast<std::uint32_t>(term_arguments_.size()), static_cast<std::uint32_t>(arguments.size())});
  term_arguments_.insert(term_arguments_.end(), arguments.begin(), arguments.end());
  term_table_.insert(hash, id);
  return TermId{id};
}

Ontology::Form Ontology::own_form(TermKind kind, NameId name, std::span<const TermId> arguments) {
  if (!is_well_formed(kind, kinds_of(arguments))) return Form::malformed;
  if (kind == TermKind::literal && !is_of_its_datatype(this->name(name), arguments)) return Form::ill_typed;
  if (kind == TermKind::datatype_restriction && !has_its_facets(*this, arguments)) return Form::foreign;
  return Form::good;
}

bool Ontology::is_of_its_datatype(std::string_view lexical, std::span<const TermId> arguments) const {
  const std::string_view language = arguments.size() > 1 ? name_of(arguments[1]) : std::string_view();
  bool is_ill_formed = false;
  static_cast<void>(DataValue::read(lexical, name_of(arguments[0]), language, is_ill_formed));
  return !is_ill_formed;
}

TermId Ontology::entity(TermKind kind, std::string_view name) {
  const NameId id = intern(name, limits_.name_bytes);
  // Most names belong to one entity, which is found without a second search.
  std::uint32_t& known = entity_of_name_[static_cast<std::size_t>(id)];
  if (known != base::NumberTable::none && terms_[known].kind == kind) return TermId{known};
  const TermId found = intern_term(kind, id, 0, {});
  known = static_cast<std::uint32_t>(found);
  return found;
}

TermId Ontology::literal(std::string_view lexical, std::string_view datatype_iri, std::string_view language) {
  if (datatype_iri.empty()) datatype_iri = language.empty() ? xsd_string : rdf_lang_string;
  if (is_lenient_ && language.empty() && is_decimal_instead(lexical, datatype_iri)) {
    datatype_iri = xsd_decimal;
    ++lenient_readings_;
  }
  std::array<TermId, 2> arguments = {datatype(datatype_iri), TermId{}};
  std::size_t count = 1;
  if (!language.empty()) arguments[count++] = entity(TermKind::language_tag, language);
  return intern_term(TermKind::literal, intern(lexical, limits_.literal_bytes), 0, std::span(arguments).first(count));
}

TermId Ontology::facet(std::string_view facet_iri, TermId value) {
  return intern_term(TermKind::facet, intern(facet_iri, limits_.name_bytes), 0, std::span(&value, 1));
}

TermId Ontology::built_in(std::string_view iri, std::span<const TermId> arguments) {
  return intern_term(TermKind::built_in_atom, intern(iri, limits_.name_bytes), 0, arguments);
}

TermId Ontology::copy(TermKind kind, std::string_view name, std::uint32_t number, std::span<const TermId> arguments) {
  return intern_term(kind, intern(name, limits_.literal_bytes), number, arguments);
}

TermId Ontology::copy(const Ontology& from, TermId id) {
  const Term term = from.term(id);
  std::vector<TermId> arguments;
  for (const TermId argument : term.arguments) arguments.push_back(copy(from, argument));
  return copy(term.kind, from.name(term.name), term.number, arguments);
}

TermId Ontology::term(TermKind kind, std::span<const TermId> arguments, std::uint32_t number) {
  GEMINGA_ASSERT(std::ranges::all_of(
      arguments, [&](TermId argument) { return static_cast<std::size_t>(argument) < terms_.size(); }));
  if (is_lenient_ && kind == TermKind::datatype_restriction && is_well_formed(kind, kinds_of(arguments))) {
    const std::vector<TermId> written(arguments.begin(), arguments.end());
    if (const auto read = with_numeric_bounds(*this, written)) {
      ++lenient_readings_;
      return intern_term(kind, NameId{0}, number, *read);
    }
    return intern_term(kind, NameId{0}, number, written);
  }
  return intern_term(kind, NameId{0}, number, arguments);
}

void Ontology::add(AxiomKind kind, std::span<const TermId> arguments, FileId file, std::uint32_t line) {
  GEMINGA_ASSERT(static_cast<std::size_t>(file) < files_.size());
  if (problem_) return;
  Form form = is_well_formed(kind, kinds_of(arguments)) ? Form::good : Form::malformed;
  std::uint32_t depth = 0;
  for (const TermId argument : arguments) {
    const TermRecord& record = terms_[static_cast<std::size_t>(argument)];
    form = std::max(form, record.form);
    depth = std::max(depth, record.depth + 1U);
  }
  if (form == Form::malformed) {
    leave_out(std::string("malformed ") + std::string(to_string(kind)), file, line);
    return;
  }
  if (depth > limits_.nesting) {
    leave_out("nesting over " + std::to_string(limits_.nesting) + " levels", file, line);
    return;
  }
  const bool is_left_out = is_ill_typed(form);
  if (is_left_out) leave_out(form == Form::ill_typed ? ill_typed_literal : foreign_facet, file, line);
  if (!is_left_out && lenient_readings_ > 0) remark(read_as_number, file, line);
  lenient_readings_ = 0;
  if (axioms_.size() + ill_typed_.size() >= limits_.axioms ||
      axiom_arguments_.size() + arguments.size() > limits_.arguments) {
    fail("the ontology has more than " + std::to_string(limits_.axioms) + " axioms or " +
         std::to_string(limits_.arguments) + " arguments");
    return;
  }
  (is_left_out ? ill_typed_ : axioms_)
      .push_back({kind, static_cast<std::uint32_t>(axiom_arguments_.size()),
                  static_cast<std::uint32_t>(arguments.size()), file, line});
  axiom_arguments_.insert(axiom_arguments_.end(), arguments.begin(), arguments.end());
}

FileId Ontology::add_file(std::string_view path, std::string_view ontology_iri) {
  if (files_.size() >= limits_.files) {
    fail("more than " + std::to_string(limits_.files) + " files");
    if (!files_.empty()) return FileId{0};
  }
  files_.push_back({std::string(path), std::string(ontology_iri), {}});
  return FileId{static_cast<std::uint32_t>(files_.size() - 1)};
}

void Ontology::set_ontology_iri(FileId file, std::string_view ontology_iri) {
  files_[static_cast<std::size_t>(file)].ontology_iri = ontology_iri;
}

void Ontology::set_content(FileId file, const Fingerprint& content) {
  files_[static_cast<std::size_t>(file)].content = content;
}

void Ontology::add_label(std::string_view entity_iri, std::string_view text, std::string_view language) {
  // A label that is too long to be typed is of no use as a name.
  if (text.empty() || text.size() > limits_.name_bytes || problem_) return;
  labels_.push_back(
      {intern(entity_iri, limits_.name_bytes), intern(text, limits_.name_bytes), intern(language, limits_.name_bytes)});
}

void Ontology::add_conversion(std::string_view from_iri, std::string_view to_iri, std::string_view cost, FileId file,
                              std::uint32_t line, std::uint32_t cost_line) {
  if (problem_) return;
  const auto number = cost.empty() ? std::optional(usual_conversion_cost) : base::parse_number<std::uint32_t>(cost);
  if (!number || *number == 0 || *number > max_conversion_cost) {
    leave_out("geminga:conversionCost that is no whole number from 1 to " + std::to_string(max_conversion_cost), file,
              cost_line == 0 ? line : cost_line);
    return;
  }
  const Conversion added{intern(from_iri, limits_.name_bytes), intern(to_iri, limits_.name_bytes), *number, file, line};
  const auto known = std::ranges::find_if(
      conversions_, [&](const Conversion& one) { return one.from == added.from && one.to == added.to; });
  if (known != conversions_.end()) {
    if (added.cost < known->cost) *known = added;
    return;
  }
  if (conversions_.size() >= limits_.conversions) {
    return fail("the ontology has more than " + std::to_string(limits_.conversions) + " conversions");
  }
  conversions_.push_back(added);
}

void Ontology::add_unit_statement(std::string_view subject_iri, UnitWord word, std::string_view value, FileId file,
                                  std::uint32_t line) {
  if (problem_ || word == UnitWord::none || unit_statements_.size() > max_unit_statements) return;
  if (subject_iri.size() > max_unit_text_octets || value.size() > max_unit_text_octets) {
    unit_statements_.push_back({NameId{}, UnitWord::too_long, NameId{}, file, line});
    return;
  }
  unit_statements_.push_back(
      {intern(subject_iri, max_unit_text_octets), word, intern(value, max_unit_text_octets), file, line});
}

void Ontology::add_prefix(std::string_view prefix, std::string_view iri) {
  if (problem_) return;
  const Prefix added{intern(prefix, limits_.name_bytes), intern(iri, limits_.name_bytes)};
  const auto is_same = [&](const Prefix& known) { return known.prefix == added.prefix && known.iri == added.iri; };
  if (std::ranges::none_of(prefixes_, is_same)) prefixes_.push_back(added);
}

void Ontology::leave_out(std::string_view construct, FileId file, std::uint32_t line, std::uint32_t count) {
  note(omissions_, construct, file, line, count);
}

void Ontology::remark(std::string_view text, FileId file, std::uint32_t line, std::uint32_t count) {
  note(remarks_, text, file, line, count);
}

void Ontology::note(std::vector<Omission>& notes, std::string_view text, FileId file, std::uint32_t line,
                    std::uint32_t count) {
  if (problem_) return;
  const NameId name = intern(text.substr(0, limits_.name_bytes), limits_.name_bytes);
  // One record for each construct and file, so that a hostile file cannot make this list long by repetition. Those of
  // the file that is read stand at the end.
  for (Omission& known : std::views::reverse(notes)) {
    if (known.construct == name && known.file == file) {
      known.count += count;
      known.line = std::min(known.line, line);
      if (known.lines.size() < most_noted_lines && known.lines.back() != line) known.lines.push_back(line);
      return;
    }
  }
  notes.push_back({name, file, line, count, {line}});
}

std::vector<TermId> terms_in(const Ontology& source, std::span<const TermId> roots) {
  std::vector<TermId> found;
  std::set<TermId> seen;
  const auto add = [&](TermId id) {
    if (seen.insert(id).second) found.push_back(id);
  };
  std::ranges::for_each(roots, add);
  for (std::size_t at = 0; at < found.size(); ++at) std::ranges::for_each(source.term(found[at]).arguments, add);
  return found;
}

}  // namespace geminga::owl
