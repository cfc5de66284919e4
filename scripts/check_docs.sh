#!/usr/bin/env bash
# check_docs.sh - every public member is documented, and the comments are what Doxygen understands.
# Leaves the pages in build/docs/html/.
set -euo pipefail
cd -- "$(dirname -- "$0")/.."

command -v doxygen >/dev/null || {
    echo "check_docs.sh: doxygen is missing: apt-get install doxygen" >&2
    exit 1
}
mkdir -p build/docs
export FIRSTHIT_DOCS_FOLDER=build/docs FIRSTHIT_DOCS_WARN_AS_ERROR=FAIL_ON_WARNINGS FIRSTHIT_VERSION=""
doxygen docs/reference/Doxyfile || {
    echo "check_docs.sh: something public lacks a description (include/firsthit/, CONTRIBUTING.md)" >&2
    exit 1
}
echo "docs: every public member is described"
