#!/usr/bin/env bash
# A module without any library: GCNP is lines of text over TCP. Offers a service by name, asks for it, and prints what
# the daemon says about it. Usage: raw_gcnp.sh [ADDRESS PORT]
set -euo pipefail
connect=${GEMINGA_CONNECT:-127.0.0.1:4717}
exec 3<>"/dev/tcp/${1:-${connect%:*}}/${2:-${connect##*:}}"

say() { printf '%s\r\n' "$1" >&3; }
hear() { IFS= read -r -t 30 line <&3 && line=${line%$'\r'} && printf '%s\n' "$line"; }

say '0 sys hello name=shell'
hear # 0 msg hello version=1 participant=... peer=... name=shell ontology=...

say '1 pub create mode=oto text="front camera" port=5000 rate=30'
say '2 sub create mode=oto text="front camera" where="rate >= 10"'
hear # 2 pub add service=...: the subscription 2 has a provider
hear # 1 sub add subscription=...: the publication 1 has a consumer

say '3 pub create mode=oto id=7 port=70000'
hear # 3 400 ...: an error about 3, and nothing else is lost

say '0 sys ping'
hear # 0 msg pong: everything before has been handled
say '0 sys bye'
! hear # the daemon has withdrawn all and closed
