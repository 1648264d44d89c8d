#!/usr/bin/env bash
# Builds the page with its engine and tests it with the command: check.sh COMMAND. Skipped (77) where
# a program or npm's packages are missing.
set -euo pipefail
export CRAZE_COMMAND=$(realpath "$1")
for program in em++ node npm chromium; do
  if ! command -v "$program" > /dev/null; then
    echo "no $program"
    exit 77
  fi
done
cd "$(dirname "$0")/../../web"
if [[ ! -d node_modules ]] && ! npm ci --no-audit --no-fund; then
  echo "no packages of npm"
  exit 77
fi
npm run build
npm test
