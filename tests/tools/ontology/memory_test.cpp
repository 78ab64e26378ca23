// The peak memory of check and compile for small files with many consequences, and for files with one huge element.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <zlib.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

constexpr long mebibyte = 1024;  // in KiB, as the kernel counts

/// The peak resident size of one run of the program, in KiB, without other children of this process.
long peak_kib(const Program& program, const std::vector<std::string>& arguments) {
  const pid_t child = fork();
  if (child == 0) {
    // The child of this child is the program, and the only one that it waits for.
    (void)program.run(arguments);
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    program.write("peak", std::to_string(usage.ru_maxrss));
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return std::stol(program.read("peak"));
}

void expect_peak(const Program& program, const std::string& file, long most_mib) {
  EXPECT_LT(peak_kib(program, {"check", file}), most_mib * mebibyte) << file;
  EXPECT_LT(peak_kib(program, {"compile", file, "-o", "out.geminga"}), most_mib * mebibyte) << file;
}

/// 61 lines, each of which names the next class twice.
std::string doubling(const std::string& line) {
  std::string text;
  for (int at = 0; at < 60; ++at) {
    std::string one = line;
    for (std::size_t mark = one.find('@'); mark != std::string::npos; mark = one.find('@'))
      one.replace(mark, 1, std::to_string(at));
    for (std::size_t mark = one.find('$'); mark != std::string::npos; mark = one.find('$'))
      one.replace(mark, 1, std::to_string(at + 1));
    text += one + '\n';
  }
  return text;
}

class Memory : public testing::Test {
 protected:
  void SetUp() override {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "what is resident here is the sanitizer's: freed blocks in quarantine, and shadow memory";
#endif
  }
};

TEST_F(Memory, FilesThatMeanTwoToTheSixtiethStayUnder128MiB) {
  const std::vector<std::pair<std::string, std::string>> files{
      {"and.ttl", doubling("_:c@ a owl:Class ; owl:intersectionOf ( _:c$ _:c$ ) .")},
      {"or.ttl",
       doubling("_:c@ a owl:Class ; owl:unionOf ( [ a owl:Restriction ; owl:onProperty :p ; "
                "owl:someValuesFrom _:c$ ] [ a owl:Restriction ; owl:onProperty :q ; owl:allValuesFrom _:c$ ] ) .")},
      {"some.ttl", doubling(":C@ rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; owl:someValuesFrom :C$ ] , "
                            "[ a owl:Restriction ; owl:onProperty :q ; owl:someValuesFrom :C$ ] .")},
      {"not.ttl", doubling(":C@ owl:equivalentClass [ a owl:Class ; owl:unionOf ( [ a owl:Restriction ; owl:onProperty "
                           ":p ; owl:someValuesFrom :C$ ] [ a owl:Class ; owl:complementOf [ a owl:Restriction ; "
                           "owl:onProperty :q ; owl:someValuesFrom :C$ ] ] ) ] .")}};
  for (const auto& [name, lines] : files) {
    const Program program;
    program.turtle(name, lines + "_:c60 a owl:Class ; owl:complementOf :B . :A rdfs:subClassOf _:c0 .\n");
    expect_peak(program, name, 128);
  }
}

TEST_F(Memory, ALiteralOfTwoHundredMegabytesStaysUnder64MiB) {
  const std::string label = "http://www.w3.org/2000/01/rdf-schema#label";
  const Program program;
  const auto refused = [&](const std::string& name, const std::string& before, const std::string& after) {
    {
      // In pieces: the resident size of this process counts for its children until exec().
      std::ofstream file(program.folder() / "in" / name);
      const std::string piece(1'000'000, 'x');
      file << before;
      for (int count = 0; count < 200; ++count) file << piece;
      file << after;
    }
    expect_peak(program, name, 64);
    std::filesystem::remove(program.folder() / "in" / name);
  };
  refused("a.nt", "<http://e/A> <" + label + "> \"", "\" .\n");
  refused("a.ttl", "<http://e/A> <" + label + "> \"\"\"", "\"\"\" .\n");
  refused("a.ofn", "Ontology(<http://e/o>\nAnnotationAssertion(<" + label + "> <http://e/A> \"", "\")\n)\n");
  refused("a.owl",
          "<?xml version=\"1.0\"?>\n<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
          "xmlns:rdfs=\"http://www.w3.org/2000/01/rdf-schema#\"><rdf:Description rdf:about=\"http://e/A\"><rdfs:label>",
          "</rdfs:label></rdf:Description></rdf:RDF>\n");
}

TEST_F(Memory, ACycleOfTwentyThousandClassesIsRefusedWithinItsLimit) {
  const Program program;
  std::string text;
  constexpr int count = 20'000;
  for (int at = 0; at < count; ++at)
    text += ":c" + std::to_string(at) + " rdfs:subClassOf :c" + std::to_string((at + 1) % count) + " .\n";
  program.turtle("cycle.ttl", text);
  EXPECT_LT(peak_kib(program, {"query", "cycle.ttl", "ASK { ?s ?p ?o }"}), 1280 * mebibyte);
  EXPECT_LT(peak_kib(program, {"infer", "cycle.ttl", "--closure", "-o", "out.nt"}), 1280 * mebibyte);
  const Outcome refused = program.run({"infer", "cycle.ttl", "--closure", "-o", "out.nt", "--memory-limit", "512"});
  EXPECT_EQ(refused.status, 4) << refused.err;
  EXPECT_NE(refused.err.find("the triples take more than 256 MiB in all"), std::string::npos) << refused.err;
  EXPECT_EQ(program.run({"query", "cycle.ttl", "ASK { ?s ?p ?o }", "--memory-limit", "512"}).status, 4);
  EXPECT_EQ(program.run({"query", "cycle.ttl", "ASK { ?s ?p ?o }", "--asserted"}).status, 0);
  EXPECT_EQ(program.run({"infer", "cycle.ttl", "-o", "out.nt"}).status, 0) << "direct relations are few";
}

TEST_F(Memory, APackedFileOfOneMegabyteStaysUnder128MiB) {
  const Program program;
  const std::string path = (program.folder() / "in/bomb.nt.gz").string();
  const gzFile file = gzopen(path.c_str(), "wb6");
  ASSERT_NE(file, nullptr);
  std::string lines;
  for (int at = 0; at < 300; ++at) lines += "<http://e/a> <http://e/b> <http://e/c> .\n";
  std::uint32_t number = 1;
  for (int line = 0; line < 16'000; ++line) {
    std::string noise = "# ";  // about 0.7 MB of it cannot be packed
    for (int at = 0; at < 60; ++at) {
      number = number * 1'664'525 + 1'013'904'223;
      noise += static_cast<char>('0' + (number >> 24U) % 64);
    }
    gzputs(file, (noise + '\n' + lines).c_str());
  }
  ASSERT_EQ(gzclose(file), Z_OK);
  EXPECT_LT(std::filesystem::file_size(path), 2'000'000U);
  EXPECT_LT(peak_kib(program, {"check", "bomb.nt.gz"}), 192 * mebibyte);
  EXPECT_EQ(program.run({"check", "bomb.nt.gz"}).status, 2);
}

TEST_F(Memory, PropertiesWhoseClosureIsQuadraticAreRefused) {
  std::string text;
  for (int at = 0; at < 5000; ++at) {
    text += ":p" + std::to_string(at) + " a owl:TransitiveProperty ; rdfs:subPropertyOf :p" + std::to_string(at + 1) +
            " .\n";
  }
  const Program program;
  program.turtle("roles.ttl", text);
  expect_peak(program, "roles.ttl", 128);
}

}  // namespace
}  // namespace geminga::ontology
