#!/bin/sh
# parallel.sh CRAZE SOURCE WORK: GNU parallel, killed and begun again with other shards; so too a
# set of fewer samples that grows.
command -v parallel >/dev/null || {
  echo "skipped: no GNU parallel (apt: parallel)"
  exit 77
}
. "$(dirname "$0")/plan.sh"
shards() {
  seq "$1" | parallel --will-cite --halt never -j 3 \
    "$craze" dataset plan.toml -o "$2" --threads 1 --quiet --shard "{}/$1"
}
# Each process in a group of its own, so that all of it can be killed at once.
disturbed() {
  for pause in 0.1 0.3 0.7; do
    setsid sh -c "seq 5 | parallel --will-cite -j 3 '$craze' dataset plan.toml -o $1 --threads 1 \
      --quiet --shard {}/5" 2>/dev/null &
    group=$!
    sleep $pause
    kill -9 -- -$group 2>/dev/null || true
    wait $group 2>/dev/null || true
    pkill -9 -s $group 2>/dev/null || true
  done
  shards 4 "$1"
  expect_same "$1"
}
disturbed out
"$craze" dataset plan.toml -o grown --quiet --samples 9
disturbed grown
