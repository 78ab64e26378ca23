"""What the library knows without a socket or a clock: lines, frames, identities, requests, and what is believed."""
