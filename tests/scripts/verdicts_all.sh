#!/bin/bash
# The verdicts on all that the papers show are those of reference/verdicts.json, but for those on times. Prints TAP.
set -u
if [ -z "${TS_SCENES:-}" ]; then
	echo "1..0 # SKIP TS_SCENES names no models"
	exit
fi
scripts/verdicts 2> /dev/null | sed 's/^/# /' | grep .
if [ "${PIPESTATUS[0]}" -eq 0 ]; then echo "ok 1 - verdicts"; else echo \
	"not ok 1 - verdicts: scripts/verdicts --write"; fi
echo "1..1"
