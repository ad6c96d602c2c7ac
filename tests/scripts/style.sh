#!/bin/bash
# The text of the sources keeps to the style. Prints TAP.
set -u
if ! git rev-parse --git-dir >/dev/null 2>&1; then
	echo "1..0 # SKIP not a git checkout"
	exit
fi
if scripts/style-check; then echo "ok 1 - style"; else echo "not ok 1 - style"; fi
echo "1..1"
