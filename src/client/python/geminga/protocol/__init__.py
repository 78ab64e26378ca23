"""The protocol without sockets and clocks: lines, frames, identities, requests, and what is believed."""
