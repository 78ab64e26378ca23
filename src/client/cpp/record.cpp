#include "client/cpp/record.hpp"

#include <optional>

#include "discovery/gcnp/attribute.hpp"

namespace geminga::client {

Record record_of(const gcnp::Statement& message) {
  Record record;
  record.kind = message.subcommand;
  // `why` names services, too, but none of their attributes.
  const bool is_service = message.subcommand != "why" && (message.has("service") || message.has("subscription"));
  const bool is_participant = message.subcommand == "participants";
  const bool is_converted = message.has("convert");   // then an attribute of these names is `attr.cost` or `attr.via`
  const bool is_relayed = message.has("hops");        // then an attribute `path` is `attr.path`
  const bool is_near = message.has("missing_count");  // what comes near is told without attributes
  for (const auto& parameter : message.parameters) {
    const bool is_of_chain = is_converted && (parameter.key == "cost" || parameter.key == "via");
    // A participant's own keys are no reserved words: its attributes always have the prefix.
    const bool may_be_attribute = is_service ? !is_of_chain && !is_near && !(is_relayed && parameter.key == "path")
                                             : is_participant && parameter.key.starts_with(attribute_prefix);
    const auto attribute = may_be_attribute ? gcnp::shown_attribute(parameter.key) : std::nullopt;
    if (attribute) {
      record.attributes.emplace(*attribute, parameter.value.value_or(""));
    } else {
      record.fields.emplace_back(parameter.key, parameter.value.value_or(""));
    }
  }
  return record;
}

}  // namespace geminga::client
