/** The protocol without sockets and clocks: lines of GCNP, frames, identities, what is believed, and what has been stated. */
package geminga.protocol;
