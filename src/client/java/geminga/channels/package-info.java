/** Sockets: the link to the daemon, outlets of publishers, inlets of subscribers, and the loop that serves them. */
package geminga.channels;
