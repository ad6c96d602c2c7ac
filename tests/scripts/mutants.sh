#!/bin/bash
# Every defect that scripts/mutants plants has its place in the sources; the defects themselves are run by
# `make mutants`. Prints TAP.
set -u
scripts/mutants --texts | sed 's/^/# /'
if [ "${PIPESTATUS[0]}" -eq 0 ]; then echo "ok 1 - texts of the mutants"; else echo \
	"not ok 1 - texts of the mutants"; fi
echo "1..1"
