#!/bin/bash
# Who reads which parameter is what src/study/asked/reads.def says, no more and no less. Prints TAP.
set -u
if scripts/reads | diff src/study/asked/reads.def - | sed 's/^/# /' | grep .; then
	echo "not ok 1 - who reads which parameter (<: reads.def, >: the runs): scripts/reads --write"
else
	echo "ok 1 - who reads which parameter"
fi
echo "1..1"
