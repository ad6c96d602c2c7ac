#!/bin/bash
# What programs rely on is what tests/headers/abi.txt says: functions, places of members, constants. A change before 1.0
# raises the second number of the version, unless only ends of structs grow. Prints TAP.
set -u
if scripts/abi --check > "${TMPDIR:-/tmp}/abi.$$"; then
	echo "ok 1 - programs that were built with these headers go on"
else
	echo "not ok 1 - the headers say otherwise than tests/headers/abi.txt (scripts/abi --write)"
	sed 's/^/# /' "${TMPDIR:-/tmp}/abi.$$"
fi
rm -f "${TMPDIR:-/tmp}/abi.$$"
echo "1..1"
