#!/usr/bin/env bash
# test.sh - installs what is missing, builds, and runs all tests. Words are passed on to ctest:
# ./test.sh -R floors
set -euo pipefail
cd -- "$(dirname -- "$0")"

scripts/install_packages.sh build test
scripts/fetch_scenes.sh || [ $? -eq 3 ]
scripts/build.sh release -D FIRSTHIT_WERROR="${FIRSTHIT_WERROR:-OFF}"
source scripts/test_environment.sh
ctest --preset release -j "$(nproc)" "$@"
