#!/bin/bash
# Every program of fuzzing compiles: `make fuzz` is run by hand. Prints TAP.
set -u
n=0
for program in tests/fuzz/*.c; do
	n=$((n + 1))
	gcc -std=c11 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Werror -fsyntax-only -Iinclude -iquote src -iquote . \
		"$program"
	[ $? -eq 0 ] || printf 'not '
	echo "ok $n - $(basename "$program")"
done
echo "1..$n"
