"""Sockets: the link to the daemon, outlets of publishers, inlets of subscribers (src/client/CHANNELS.md, "Who opens what")."""
