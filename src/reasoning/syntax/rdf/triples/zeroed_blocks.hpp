// Gives raptor its zeroed memory from the cache of the thread that asks.
//
// Raptor asks for two blocks of five by calloc, which in glibc before 2.41 takes none from the cache of its thread: it
// locks the heap and searches it, though free() has put such blocks into the cache. The calloc of zeroed_blocks.cpp
// takes the place of glibc's in this program, as ELF has it for names that a program and a library define. For
// blocks that a cache may have it is a malloc, which asks the cache first, and zeroes what it gets. Sanitizers have a
// calloc of their own, which stays.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_ZEROED_BLOCKS_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_ZEROED_BLOCKS_HPP

namespace geminga::rdf {

/// Whether calls of calloc, those of libraries too, come to zeroed_blocks.cpp.
[[nodiscard]] bool has_zeroed_blocks();

}  // namespace geminga::rdf

#endif
