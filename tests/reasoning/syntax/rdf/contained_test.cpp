// Hostile and odd files, each read by a watched process: what it opens, whether it asks for a connection, what it
// costs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "reasoning/syntax/rdf/reading.hpp"
#include "reasoning/syntax/rdf/scratch.hpp"
#include "reasoning/syntax/rdf/watched.hpp"

namespace geminga::rdf {
namespace {

using testing::StartsWith;

/// Processor time that a file may cost, in seconds, and memory. The sanitizers need several times as much of both.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr unsigned seconds = 20;
constexpr long peak_kib = 2048 * 1024;
#else
constexpr unsigned seconds = 2;
constexpr long peak_kib = 128 * 1024;
#endif

/// Reads what is in a folder, and gives "accepted", or why not with paths cut to their last part.
std::string read(const std::vector<std::string>& arguments, const std::string& folder) {
  const auto loaded = load(arguments);
  std::string text = loaded ? "accepted" : to_string(loaded.error());
  for (std::size_t at = text.find(folder + '/'); at != std::string::npos; at = text.find(folder + '/'))
    text.erase(at, folder.size() + 1);
  return text;
}

/// Expects that only files below the folder are opened, nothing is connected, and what is said. `own` may be opened.
void expect_contained(const Scratch& scratch, const std::vector<std::string>& arguments, const std::string& said,
                      const std::vector<std::string>& own) {
  const Watched watched = watch(seconds, [&] { return read(arguments, scratch.path().string()); });
  EXPECT_EQ(watched.status, 0) << "killed, or out of time: expected " << said;
  EXPECT_THAT(watched.said, StartsWith(said));
  EXPECT_FALSE(watched.asked_for_sockets) << said;
  EXPECT_FALSE(watched.asked_for_programs) << said;
  EXPECT_LT(watched.peak_kib, peak_kib) << said;
  for (const std::string& path : watched.opened) {
    const bool is_own = path == scratch.path() || std::ranges::any_of(own, [&](const std::string& name) {
                          return path == scratch.path() / name;
                        });
    EXPECT_TRUE(is_own || path.starts_with("/sys/devices/system/cpu")) << path << " was opened: " << said;
  }
}

/// One file, and how the refusal begins behind its name.
struct Hostile {
  std::string name;
  std::string content;
  std::string said;
};

std::string described(std::string_view text) {
  return "<rdf:Description rdf:about='http://e/A'><rdfs:label>" + std::string(text) +
         "</rdfs:label></rdf:Description>\n";
}

std::vector<Hostile> hostile_files() {
  using std::string_literals::operator""s;
  std::string laughs = "<!DOCTYPE rdf:RDF [\n<!ENTITY a0 'haha'>\n";
  for (int i = 1; i < 30; ++i)
    laughs += "<!ENTITY a" + std::to_string(i) + " '" + times(10, "&a" + std::to_string(i - 1) + ";") + "'>\n";
  const std::string secret = "file:///etc/passwd";
  const std::string connection = "http://127.0.0.1:9/x";
  const auto doctype = [](const std::string& inside) { return "<!DOCTYPE rdf:RDF [" + inside + "]>\n"; };
  return {
      {"laughs.owl", xml(described("&a29;"), laughs + "]>\n"), ":7: declares the entity a4"},
      {"name.owl", xml("<e:A rdf:about='&x;'/>", doctype("<!ENTITY x SYSTEM '" + secret + "'>")), ":4: refers to"},
      {"inner.owl", xml(described("x"), doctype("<!ENTITY % x '<!ENTITY y SYSTEM \"" + secret + "\">'> %x;")),
       ":2: declares a parameter"},
      {"deep.owl", xml(times(100'000, "<e:A><e:p>")), ":3: nests elements"},
      {"deep.ttl", "<http://e/a> <http://e/p> " + times(100'000, "[ <http://e/p> "), ":1: nests brackets"},
      {"lists.ttl", "<http://e/a> <http://e/p> " + times(100'000, "("), ":1: nests brackets"},
      {"literal.nt", "<http://a> <http://b> \"" + times(4'000'000, "x") + "\" .\n", ":1: has a literal"},
      {"literal.ttl", "\n<http://a> <http://b> \"\"\"" + times(4'000'000, "x"), ":2: has a literal"},
      {"text.owl", xml("\n" + described(times(4'000'000, "x"))), ":4: has a text"},
      {"attribute.owl", xml("<e:A e:p='" + times(4'000'000, "x") + "'/>"), ":3: has an attribute"},
      {"nul.ttl", "\n<http://a> <http://b\0c> <http://d> .\n"s, ":2: holds a NUL byte"},
      {"utf8.owl", xml("\n" + described("\xc3\x28")), ":4: holds bytes that are no UTF-8"},
      {"wide.owl", "\xff\xfe\0\0<\0\0\0"s, ": is in UTF-32"},
      {"page.owl", "<!DOCTYPE html>\n<html>" + times(1000, "<p>") + "</html>", ": is an HTML page"},
      {"empty.owl", "", ": is empty"},
      {"dashes.owl", xml("<!--" + times(1'000'000, "-")), ":3: has -- inside a comment"},
      {"attributes.owl", xml("<e:A " + times(100'000, "e:p='' ") + "/>"), ":3: has an element with more than"},
      {"statement.ttl", "<http://a> <http://b> 1" + times(500'000, ",1") + ".", ":1: has a statement of more than"},
      {"prefixes.ttl", times(20'000, "@prefix a: <http://e/> .\n"), ":10001: declares more than 10000 prefixes"},
  };
}

TEST(Contained, EveryHostileFileIsRefusedWithItsLineAtLittleCost) {
  for (const Hostile& file : hostile_files()) {
    const Scratch scratch;
    expect_contained(scratch, {scratch.write(file.name, file.content)}, file.name + file.said, {file.name});
  }
}

TEST(Contained, WhatAFileNamesIsNeverOpened) {
  const Scratch scratch;
  const std::string names = "<file:///etc/passwd>, <http://127.0.0.1:9/x>, <secret.ttl>, <../secret.ttl>";
  scratch.write("secret.ttl", "not read");
  const std::string turtle = scratch.write(
      "a.ttl",
      "@base <file:///etc/> . @prefix owl: <http://www.w3.org/2002/07/owl#> .\n<http://e/a> a owl:Ontology ; "
      "owl:imports " +
          names + "; <http://www.w3.org/2000/01/rdf-schema#seeAlso> " + names + " .\n");
  const std::string elements = scratch.write(
      "b.owl",
      "<?xml version='1.0'?>\n<?xml-stylesheet href='file:///etc/passwd' type='text/xsl'?>\n"
      "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#' xml:base='http://127.0.0.1:9/'\n"
      "  xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance' xsi:schemaLocation='x file:///etc/passwd'\n"
      "  xmlns:xi='http://www.w3.org/2001/XInclude' xmlns:e='http://e/'>\n"
      "<e:A><e:p rdf:parseType='Literal'><xi:include href='file:///etc/passwd' parse='text'/></e:p></e:A>\n"
      "</rdf:RDF>\n");
  expect_contained(scratch, {turtle, elements}, "accepted", {"a.ttl", "b.owl"});
}

TEST(Contained, ImportsInACircleEnd) {
  const Scratch scratch;
  const auto ontology = [](const std::string& name, const std::string& imported) {
    return "<http://e/" + name +
           "> a <http://www.w3.org/2002/07/owl#Ontology> ; <http://www.w3.org/2002/07/owl#imports> "
           "<http://e/" +
           imported + "> .\n";
  };
  scratch.write("a.ttl", ontology("a", "b"));
  scratch.write("b.ttl", ontology("b", "c"));
  scratch.write("c.ttl", ontology("c", "a"));
  expect_contained(scratch, {scratch.path().string()}, "accepted", {"a.ttl", "b.ttl", "c.ttl"});
}

TEST(Contained, WhatIsNoFileIsNeverOpened) {
  const Scratch scratch;
  scratch.write("folder.ttl/inside.ttl", "");
  ASSERT_EQ(mkfifo((scratch.path() / "fifo.ttl").c_str(), 0600), 0);
  expect_contained(scratch, {(scratch.path() / "fifo.ttl").string()}, "fifo.ttl: is a FIFO, not a regular file", {});
  expect_contained(scratch, {scratch.path().string()}, "fifo.ttl: is a FIFO, not a regular file", {"folder.ttl"});
  expect_contained(scratch, {"/dev/zero"}, "/dev/zero: is a device, not a regular file", {});
  expect_contained(scratch, {"/dev/tty"}, "/dev/tty: is a device, not a regular file", {});

  const Scratch linked;
  std::filesystem::create_symlink("/etc/passwd", linked.path() / "secret.ttl");
  expect_contained(linked, {linked.path().string()}, "secret.ttl: is a link that leads out of its folder", {});
}

TEST(Contained, WhatADoctypeNamesIsNeverOpened) {
  const std::string secret = "file:///etc/passwd";
  const std::string connection = "http://127.0.0.1:9/x";
  const auto doctype = [](const std::string& inside) { return "<!DOCTYPE rdf:RDF [" + inside + "]>\n"; };
  for (const std::string& content : {xml(described("&x;"), doctype("<!ENTITY x SYSTEM '" + secret + "'>")),
                                     xml(described("&x;"), doctype("<!ENTITY x SYSTEM '" + connection + "'>")),
                                     xml(described("&y;"), doctype("<!ENTITY % x SYSTEM '" + secret + "'> %x;")),
                                     xml(described("&y;"), "<!DOCTYPE rdf:RDF SYSTEM '" + connection + "'>\n"),
                                     xml(described("&y;"), "<!DOCTYPE rdf:RDF PUBLIC '-//W3C' '" + secret + "'>\n"),
                                     xml(described("x"), doctype("<!NOTATION n SYSTEM '" + secret + "'>"))}) {
    const Scratch scratch;
    expect_contained(scratch, {scratch.write("a.owl", content)}, "accepted", {"a.owl"});
  }
}

TEST(Contained, ACatalogueOpensNothing) {
  const Scratch scratch;
  scratch.write("a.ttl", "");
  scratch.write("catalog-v001.xml",
                "<?xml version='1.0'?>\n<!DOCTYPE catalog SYSTEM 'file:///etc/passwd'>\n<catalog/>\n");
  expect_contained(scratch, {scratch.path().string()}, "accepted", {"a.ttl", "catalog-v001.xml"});
}

TEST(Watched, SeesFilesSocketsAndTheEndOfTime) {
  const Watched opened = watch(5, [] {
    const bool is_there = std::fopen("/no/such/file", "r") != nullptr;
    close(socket(AF_INET, SOCK_DGRAM, 0));
    return std::string(is_there ? "there" : "not there");
  });
  EXPECT_THAT(opened.opened, testing::Contains("/no/such/file"));
  EXPECT_TRUE(opened.asked_for_sockets);
  EXPECT_EQ(opened.said, "not there");
  const Watched endless = watch(1, [] {
    for (volatile unsigned spin = 0;;) spin = spin + 1;
    return std::string();
  });
  EXPECT_TRUE(WIFSIGNALED(endless.status));
}

}  // namespace
}  // namespace geminga::rdf
