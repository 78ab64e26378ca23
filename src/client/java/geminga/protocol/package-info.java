/** What a client is without its sockets: lines of GCNP, frames, identities, what is believed, and what has been stated. Nothing here does I/O or looks at a clock. */
package geminga.protocol;
