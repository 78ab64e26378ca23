#!/usr/bin/env bash
# together.sh FOLDER EXAMPLE EXPECTED: runs the example publish beside another one and compares the other's first line.
set -euo pipefail
exec 3< <(exec "$1/publish")
provider=$!
trap 'kill "$provider" 2>/dev/null || true' EXIT
read -r line <&3 # "offering the ball": from now on others can be told of it
said=$("$1/$2")
printf '%s\n' "$said"
[[ ${said%%$'\n'*} == "$3" ]] || {
  printf 'expected: %s\n' "$3" >&2
  exit 1
}
