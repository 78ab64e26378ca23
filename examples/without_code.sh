#!/usr/bin/env bash
# without_code.sh [FOLDER]: services and their consumers without a line of code; FOLDER has the programs, where PATH has not.
set -euo pipefail
PATH=${1:+$1:}$PATH

# Each line of standard input is a message to whoever has asked, and each message a line of standard output.
printf 'ball %d\n' 1 2 3 | geminga-publish --text balls --mode otm/pubsub --protocol tcp --send 2>/dev/null &
geminga-subscribe --text balls --mode otm/pubsub --listen --count 3 2>/dev/null
wait

# A command runs once an event: here a camera that says who looks. A real one would begin to film, and end with `del`.
coproc camera {
  exec geminga-publish --text camera --mode oto --port 5000 2>/dev/null \
    --exec 'case $GEMINGA_EVENT in add) echo "camera: $GEMINGA_NAME came" ;; del) echo "camera: $GEMINGA_NAME went" ;; esac'
}
# Its consumer is told where it is.
geminga-subscribe --text camera --mode oto --count 1 --exec 'test "$GEMINGA_PORT" = 5000'
read -r said <&"${camera[0]}"
echo "$said"
kill "$camera_PID"
