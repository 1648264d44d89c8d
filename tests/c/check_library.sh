#!/usr/bin/env bash
# check_library.sh LIBRARY HEADER SOURCE.c...: the library shows the functions of its header and
# nothing else, and needs the C library alone; the sources call each of them.
set -euo pipefail
library=$1 header=$2
shift 2
status=0
fail() { echo "$*" >&2; status=1; }

declared=$(sed -n '/^CRAZE_API/,/;/p' "$header" | grep -o 'craze_[a-z_]*(' | tr -d '(' | sort -u)
shown=$(readelf --dyn-syms --wide "$library" |
  awk '$5 == "GLOBAL" || $5 == "WEAK" {if ($7 != "UND") print $8}' | sed 's/@.*//' | sort -u)
[ "$(wc -l <<< "$declared")" -gt 30 ] || fail "the header declares hardly anything"
[ "$declared" = "$shown" ] || fail "shown and declared differ:" \
  "$(diff <(echo "$declared") <(echo "$shown") || true)"

needed=$(readelf --dynamic --wide "$library" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p')
for name in $needed; do
  case $name in
    libc.so.* | libm.so.* | libpthread.so.* | ld-linux*) ;;
    *) fail "needs $name" ;;
  esac
done

for name in $declared; do
  grep -q "$name(" "$@" || fail "no test calls $name"
done
exit $status
