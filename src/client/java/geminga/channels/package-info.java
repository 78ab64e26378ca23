/** The sockets of a client and the one selector that serves them. */
package geminga.channels;
