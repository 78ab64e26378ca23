"""The sockets of channels: outlets of publishers, inlets of subscribers (src/client/CHANNELS.md, "Who opens what")."""
