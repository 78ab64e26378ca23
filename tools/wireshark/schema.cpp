// Writes the messages of a schema as a table of Lua, from which dissector.lua makes its fields. The build runs it on
// what protoc --descriptor_set_out --include_source_info says of announcement.proto.
#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>

#include <fstream>
#include <iostream>
#include <string>
#include <string_view>

namespace geminga::wireshark {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::EnumDescriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::FileDescriptor;
using google::protobuf::SourceLocation;

/// A string of Lua, in one line.
std::string in_lua(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '\n') {
      quoted += ' ';
    } else {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += c;
    }
  }
  return quoted + '"';
}

/// The comment above or beside an element, without spaces at its ends.
template <typename Element>
std::string comment_of(const Element& element) {
  SourceLocation location;
  if (!element.GetSourceLocation(&location)) return {};
  std::string text = location.leading_comments.empty() ? location.trailing_comments : location.leading_comments;
  std::string line;
  for (const char c : text) {
    if ((c == ' ' || c == '\n') && (line.empty() || line.back() == ' ')) continue;
    line += c == '\n' ? ' ' : c;
  }
  while (line.ends_with(' ')) line.pop_back();
  return line;
}

void write_enum(const EnumDescriptor& type) {
  std::cout << "    " << type.name() << " = {";
  for (int i = 0; i < type.value_count(); ++i) {
    std::cout << (i == 0 ? "" : ", ") << '[' << type.value(i)->number() << "] = " << in_lua(type.value(i)->name());
  }
  std::cout << "},\n";
}

void write_field(const FieldDescriptor& field) {
  std::cout << "      [" << field.number() << "] = {name = " << in_lua(field.name())
            << ", kind = " << in_lua(field.type_name());
  if (field.message_type() != nullptr) std::cout << ", message = " << in_lua(field.message_type()->name());
  if (field.enum_type() != nullptr) std::cout << ", enum = " << in_lua(field.enum_type()->name());
  std::cout << ", repeated = " << (field.is_repeated() ? "true" : "false") << ", about = " << in_lua(comment_of(field))
            << "},\n";
}

void write_schema(const FileDescriptor& file) {
  std::cout << "-- Made from " << file.name() << ".\nlocal schema = {\n  enums = {\n";
  for (int i = 0; i < file.enum_type_count(); ++i) write_enum(*file.enum_type(i));
  std::cout << "  },\n  messages = {\n";
  for (int i = 0; i < file.message_type_count(); ++i) {
    const Descriptor& message = *file.message_type(i);
    std::cout << "    " << message.name() << " = {\n";
    for (int j = 0; j < message.field_count(); ++j) write_field(*message.field(j));
    std::cout << "    },\n";
  }
  std::cout << "  },\n}\n\n";
}

int run(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  google::protobuf::FileDescriptorSet set;
  if (!set.ParseFromIstream(&in) || set.file_size() != 1) {
    std::cerr << path << ": is no description of one schema\n";
    return 1;
  }
  google::protobuf::DescriptorPool pool;
  const FileDescriptor* const file = pool.BuildFile(set.file(0));
  if (file == nullptr) return 1;
  write_schema(*file);
  return std::cout.flush() ? 0 : 1;
}

}  // namespace
}  // namespace geminga::wireshark

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "geminga_wireshark_schema: name a file of protoc --descriptor_set_out\n";
    return 2;
  }
  return geminga::wireshark::run(argv[1]);
}
