#!/usr/bin/env bash
# Makes the Debian packages of build/release, asks lintian, and installs and runs them in a bare
# Debian 12: scripts/check_debs.sh; as root, after the preset "release". Each package comes with what
# it depends on and nothing else, so that what it forgot to ask for is missing.
set -euo pipefail
cd "$(dirname "$0")/.."
[ -f web/dist/index.html ] || (cd web && npm ci --no-audit --no-fund && npm run build)
debs=build/debs root=$(mktemp -d)
trap 'umount -q "$root/proc" || true; rm -rf "$root"' EXIT

rm -rf "$debs"
cpack -G DEB --config build/release/CPackConfig.cmake -B "$debs" > /dev/null
rm -rf "$debs/_CPack_Packages"
# Packages that go into no archive close no bug of one. cpack has ldconfig called by scripts, beside
# the trigger that Debian wants.
lintian --allow-root --fail-on error,warning --tag-display-limit 0 \
  --suppress-tags initial-upload-closes-no-bugs,maintscript-calls-ldconfig "$debs"/*.deb

mmdebstrap --quiet --variant=apt bookworm "$root"
mount -t proc proc "$root/proc"  # by which programs find what lies beside them
cp "$debs"/*.deb tests/packages/consumer.c tests/packages/consumer.py "$root/tmp/"
cp -r tests/consumer "$root/tmp/consumer"
in_root() { chroot "$root" sh -euc "export DEBIAN_FRONTEND=noninteractive; cd /tmp; $1" < /dev/null; }
install() { in_root "apt-get install -qq -y --no-install-recommends $* > /tmp/apt.log 2>&1 || { cat /tmp/apt.log; exit 1; }"; }

in_root "apt-get update -qq"
install ./craze_*.deb
in_root "craze crack shape:cup -o cup.ply --picture cup.png --width 80 --height 60 --quiet
  test -s cup.ply && test -s cup.png
  test -s /usr/share/man/man1/craze.1.gz
  test -s /usr/share/craze/studio/index.html
  craze studio --no-browser > studio.txt & sleep 2; kill -INT \$!; wait \$! || test \$? = 130
  grep -q http://127.0.0.1: studio.txt"
install ./python3-craze_*.deb
in_root "python3 consumer.py"
install ./libcraze0_*.deb ./libcraze-dev_*.deb gcc libc6-dev
in_root "gcc -std=c99 -Wall -Wextra -Werror consumer.c -lcraze -o c-consumer && ./c-consumer"
install g++ cmake make
in_root "cmake -S consumer -B cpp -DCMAKE_BUILD_TYPE=Release > /dev/null && cmake --build cpp > /dev/null
  cpp/consumer cracked.ply && test -s cracked.ply"
echo "$(ls "$debs"/*.deb | wc -l) packages, installed and run"
