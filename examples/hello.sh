#!/usr/bin/env bash
# hello.sh PUBLISHER SUBSCRIBER [TEXT]: what the one says three times, in whatever language, the other prints.
set -euo pipefail
"$1" 3 &
publisher=$!
trap 'kill "$publisher" 2>/dev/null || true' EXIT
said=$("$2" 3)
wait "$publisher"
expected=''
for number in 1 2 3; do
  expected+=${3:-"{\"x\": 1.5, \"y\": -0.2, \"number\": $number}"}$'\n'
done
[[ $said == "${expected%$'\n'}" ]] || {
  printf 'expected:\n%s\nsaid:\n%s\n' "$expected" "$said" >&2
  exit 1
}
