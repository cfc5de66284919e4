# test_environment.sh - where tests find real scenes; sourced from the project's folder.
# Tests that need a scene which is not there are skipped.
if [ -z "${FIRSTHIT_TEST_DATA:-}" ] && [ -d ../shared/data ]; then
    FIRSTHIT_TEST_DATA=$(cd ../shared/data && pwd)
    export FIRSTHIT_TEST_DATA
fi
