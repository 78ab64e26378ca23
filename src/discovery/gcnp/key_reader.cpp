#include "discovery/gcnp/key_reader.hpp"

#include <algorithm>
#include <utility>

#include "base/address.hpp"
#include "base/text.hpp"
#include "discovery/gcnp/attribute.hpp"
#include "discovery/gcnp/limits.hpp"
#include "discovery/gcnp/reserved.hpp"

namespace geminga::gcnp {
namespace {

constexpr std::string_view converts_key = "converts";

}  // namespace

KeyReader::KeyReader(const Statement& statement) : statement_(statement), taken_(statement.parameters.size()) {
  std::vector<std::string_view> keys;
  keys.reserve(statement.parameters.size());
  for (const auto& parameter : statement.parameters) keys.push_back(parameter.key);
  std::ranges::sort(keys);
  const auto doubled = std::ranges::adjacent_find(keys);
  if (doubled != keys.end()) {
    fail(ErrorCode::malformed, base::printable(*doubled) + " is given twice: give each key once");
  }
}

void KeyReader::fail(ErrorCode code, std::string text) {
  if (!error_) error_ = Error{code, std::move(text)};
}

void KeyReader::require(bool is_there, std::string_view key, std::string_view hint) {
  if (!is_there) fail(ErrorCode::malformed, std::string(key) + " is missing: " + std::string(hint));
}

const Parameter* KeyReader::take(std::string_view key) {
  asked_.push_back(key);
  const auto parameter = std::ranges::find(statement_.parameters, key, &Parameter::key);
  if (parameter == statement_.parameters.end()) return nullptr;
  taken_[static_cast<std::size_t>(parameter - statement_.parameters.begin())] = true;
  return &*parameter;
}

std::optional<std::string_view> KeyReader::value(std::string_view key) {
  const Parameter* parameter = take(key);
  if (parameter == nullptr) return std::nullopt;
  if (!parameter->value) {
    fail(ErrorCode::malformed, std::string(key) + " has no value: write " + std::string(key) + "=VALUE");
    return std::nullopt;
  }
  return *parameter->value;
}

void KeyReader::fail_value(std::string_view key, std::string_view expected) {
  const auto given = statement_.value(key).value_or("");
  fail(ErrorCode::malformed,
       std::string(key) + '=' + base::printable(given, 60) + " cannot be read: it must be " + std::string(expected));
}

std::optional<std::string> KeyReader::text(std::string_view key, std::size_t max_bytes) {
  const auto given = value(key);
  if (!given) return std::nullopt;
  if (given->size() > max_bytes) {
    fail(ErrorCode::too_large, std::string(key) + " is too long: at most " + std::to_string(max_bytes) + " octets");
    return std::nullopt;
  }
  return std::string(*given);
}

std::optional<std::uint32_t> KeyReader::number(std::string_view key) {
  const auto given = value(key);
  if (!given) return std::nullopt;
  const auto number = base::parse_number<std::uint32_t>(*given);
  if (!number) fail_value(key, "a number from 0 to 4294967295");
  return number;
}

std::optional<std::int32_t> KeyReader::priority() {
  const auto given = value("priority");
  if (!given) return std::nullopt;
  const auto number = base::parse_number<std::int32_t>(*given);
  if (!number) fail_value("priority", "a number from -2147483648 to 2147483647; greater wins");
  return number;
}

std::optional<std::uint16_t> KeyReader::port() {
  const auto given = value("port");
  if (!given) return std::nullopt;
  const auto number = base::parse_number<std::uint16_t>(*given);
  if (number && *number != 0) return number;
  fail_value("port", "a number from 1 to 65535");
  return std::nullopt;
}

std::optional<std::string> KeyReader::address() {
  const auto given = value("address");
  if (!given) return std::nullopt;
  std::string address(*given);
  if (address.empty()) return address;
  const auto read = base::parse_address(address);
  if (!read) {
    fail(ErrorCode::impossible,
         "address=" + base::printable(address, 60) + " is no IP address: write one in numbers, or leave address out");
  } else if (read->scope() == base::AddressScope::unspecified) {
    fail(ErrorCode::impossible,
         "address=" + address + " cannot be sent to: leave address out, and each interface's own is announced");
  }
  return address;
}

std::optional<ChannelMode> KeyReader::mode() {
  const auto given = value("mode");
  if (!given) return std::nullopt;
  const auto mode = channel_mode(*given);
  if (!mode) fail_value("mode", "oto, otm/stream or otm/pubsub, or participant to ask for participants");
  return mode;
}

std::optional<Degree> KeyReader::degree(std::string_view key) {
  const auto given = value(key);
  if (!given) return std::nullopt;
  const auto degree = geminga::degree(*given);
  if (degree && *degree != Degree::converted) return degree;
  fail_value(key, "exact, equivalent, narrower, broader or overlapping");
  return std::nullopt;
}

std::optional<RequiredReach> KeyReader::reach() {
  const auto given = value("reach");
  if (!given) return std::nullopt;
  const auto reach = required_reach(*given);
  if (!reach) fail_value("reach", "routed (the default: services that can be reached from here) or any");
  return reach;
}

std::optional<std::uint32_t> KeyReader::conversion() {
  const auto given = value("convert");
  if (!given) return std::nullopt;
  if (*given == "yes") return any_cost;
  if (*given == "no") return 0;
  const auto cost = base::parse_number<std::uint32_t>(*given);
  if (!cost) fail_value("convert", "yes, no or the largest cost");
  return cost;
}

std::optional<std::vector<ProviderFilter>> KeyReader::providers(std::string_view key) {
  const auto given = value(key);
  if (!given) return std::nullopt;
  std::vector<ProviderFilter> providers;
  std::string_view rest = *given;
  while (!rest.empty()) {
    const auto comma = std::min(rest.find(','), rest.size());
    const std::string_view item = base::trimmed(rest.substr(0, comma));
    const bool is_last = comma == rest.size();
    rest.remove_prefix(is_last ? comma : comma + 1);
    const auto slash = item.find('/');
    const bool names_peer = slash != std::string_view::npos;
    ProviderFilter provider{std::string(item.substr(0, slash)), std::string(names_peer ? item.substr(slash + 1) : "")};
    if (provider.participant.empty() || (names_peer && provider.peer.empty()) || provider.peer.contains('/') ||
        (!is_last && rest.empty())) {
      fail_value(key, "PARTICIPANT or PARTICIPANT/PEER, or several of them with commas");
      return std::nullopt;
    }
    if (provider.participant.size() > max_name_bytes || provider.peer.size() > max_name_bytes) {
      fail(ErrorCode::too_large,
           "a name in " + std::string(key) + " is too long: at most " + std::to_string(max_name_bytes) + " octets");
      return std::nullopt;
    }
    if (providers.size() == max_provider_filters) {
      fail(ErrorCode::too_large,
           std::string(key) + " is too long: at most " + std::to_string(max_provider_filters) + " providers");
      return std::nullopt;
    }
    providers.push_back(std::move(provider));
  }
  return providers;
}

std::optional<std::vector<std::string>> KeyReader::protocols() {
  const auto given = value("protocol");
  if (!given) return std::nullopt;
  std::vector<std::string> protocols;
  for (std::size_t begin = 0; !given->empty() && begin <= given->size();) {
    const auto comma = std::min(given->find(',', begin), given->size());
    protocols.emplace_back(base::trimmed(given->substr(begin, comma - begin)));
    begin = comma + 1;
    if (protocols.back().empty()) {
      fail_value("protocol", "a word such as udp, or several of them with commas");
    } else if (protocols.back().size() > max_protocol_bytes) {
      fail(ErrorCode::too_large, "a protocol is too long: at most " + std::to_string(max_protocol_bytes) + " octets");
    }
  }
  if (protocols.size() > max_accepted_protocols) {
    fail(ErrorCode::too_large, "protocol is too long: at most " + std::to_string(max_accepted_protocols) + " words");
  }
  return protocols;
}

std::optional<ServiceKey> KeyReader::service_key(std::string_view key) {
  const auto given = value(key);
  if (!given) return std::nullopt;
  const auto word = geminga::service_key(*given);
  if (!word) fail_value(key, "PARTICIPANT/PEER/NUMBER, as events and queries show it");
  return word;
}

std::optional<bool> KeyReader::answer(std::string_view key) {
  const auto given = value(key);
  if (!given || *given == "yes") return given ? std::optional(true) : std::nullopt;
  if (*given != "no") fail_value(key, "yes or no");
  return false;
}

bool KeyReader::flag(std::string_view key) {
  const Parameter* parameter = take(key);
  if (parameter == nullptr) return false;
  if (!parameter->value || parameter->value == "1") return true;
  if (parameter->value != "0") fail_value(key, "0 or 1");
  return false;
}

std::optional<IdentityChange> KeyReader::identity_change() {
  const auto id = value("id");
  auto name = text("text", max_text_identity_bytes);
  ConceptChange names{text("concept", max_concept_bytes), text("representation", max_concept_bytes)};
  const bool is_semantic = names.concept_name || names.representation_name;
  if ((id ? 1 : 0) + (name ? 1 : 0) + (is_semantic ? 1 : 0) > 1) {
    fail(ErrorCode::malformed, "two identities: give one of id=N, text=NAME, and concept=C with representation=R");
    return std::nullopt;
  }
  if (id) {
    const auto number = base::parse_id32(*id);
    if (!number) fail_value("id", "a number from 0 to 4294967295, decimal or behind 0x in hexadecimal");
    return NumericIdentity{number.value_or(0)};
  }
  if (name) {
    if (name->empty()) fail_value("text", "a text that is not empty");
    return TextIdentity{std::move(*name)};
  }
  if (!is_semantic) return std::nullopt;
  if (names.concept_name && names.concept_name->empty()) fail_value("concept", "a name that is not empty");
  return names;
}

std::optional<NamedIdentity> KeyReader::identity() {
  auto change = identity_change();
  if (!change) return std::nullopt;
  if (const auto* number = std::get_if<NumericIdentity>(&*change)) return *number;
  if (auto* name = std::get_if<TextIdentity>(&*change)) return std::move(*name);
  auto& names = std::get<ConceptChange>(*change);
  require(names.concept_name.has_value(), "concept", "a representation belongs to a concept");
  return ConceptNames{std::move(names.concept_name).value_or(""), std::move(names.representation_name).value_or("")};
}

Statement KeyReader::behind(std::string_view prefix) {
  Statement inner{
      .id = statement_.id, .command = statement_.command, .subcommand = statement_.subcommand, .parameters = {}};
  for (std::size_t i = 0; i < taken_.size(); ++i) {
    const Parameter& parameter = statement_.parameters[i];
    if (taken_[i] || !parameter.key.starts_with(prefix)) continue;
    taken_[i] = true;
    inner.parameters.push_back({parameter.key.substr(prefix.size()), parameter.value});
  }
  return inner;
}

std::optional<std::string> KeyReader::attribute(std::string_view key) {
  if (may_convert_ && key == converts_key) return std::string(key);
  // The keys of this statement come first: if a word may be a slip of several, the likely one is among them.
  const bool is_told = key.starts_with(attribute_prefix) || is_reserved(key);
  if (const auto meant = is_told ? std::nullopt : mistyped_key(key, asked_)) {
    fail(ErrorCode::malformed, base::printable(key, 64) + " is no key: did you mean " + std::string(*meant) +
                                   "?; an attribute of this name is written " + std::string(attribute_prefix) +
                                   base::printable(key, 64));
    return std::nullopt;
  }
  auto name = attribute_name(key);
  if (!name) {
    fail(name.error().code, statement_.command + ' ' + statement_.subcommand + ": " + std::move(name.error().text));
    return std::nullopt;
  }
  if (name->size() > max_attribute_key_bytes) {
    fail(ErrorCode::too_large, "the key of an attribute has at most " + std::to_string(max_attribute_key_bytes) +
                                   " octets: " + base::printable(*name, 40));
  }
  return std::move(*name);
}

Attributes KeyReader::offered_attributes() {
  may_convert_ = true;
  asked_.push_back(converts_key);
  return attributes();
}

Attributes KeyReader::attributes() {
  Attributes attributes;
  for (std::size_t i = 0; i < taken_.size(); ++i) {
    if (taken_[i]) continue;
    const Parameter& parameter = statement_.parameters[i];
    taken_[i] = true;
    auto name = attribute(parameter.key);
    if (!name) return {};
    const std::string_view given = parameter.value ? std::string_view(*parameter.value) : "";
    if (given.size() > max_attribute_value_bytes) {
      fail(ErrorCode::too_large, "attribute " + base::printable(*name, 64) + " is too long: at most " +
                                     std::to_string(max_attribute_value_bytes) + " octets");
    }
    if (parameter.key == converts_key && !given.empty() && !given.contains('>')) {
      fail(ErrorCode::malformed,
           "converts: " + base::printable(given, 64) +
               " is no conversion: did you mean converts=FROM>TO?; an attribute of this name is " +
               "written attr.converts");
    }
    if (!attributes.emplace(std::move(*name), given).second) {
      fail(ErrorCode::malformed,
           base::printable(parameter.key, 64) + " is given twice, with and without its prefix: give it once");
    }
  }
  if (attributes.size() > max_attributes) {
    fail(ErrorCode::too_large, "too many attributes: at most " + std::to_string(max_attributes));
  }
  return attributes;
}

void KeyReader::finish() {
  const auto left = std::ranges::find(taken_, false);
  if (left == taken_.end()) return;
  const auto& key = statement_.parameters[static_cast<std::size_t>(left - taken_.begin())].key;
  const auto meant = mistyped_key(key, asked_);
  fail(ErrorCode::malformed, base::printable(key, 64) + " is no key of " + statement_.command + ' ' +
                                 statement_.subcommand + (meant ? ": did you mean " + std::string(*meant) + "?" : ""));
}

}  // namespace geminga::gcnp
