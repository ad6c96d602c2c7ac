#!/bin/bash
# Every public header compiles alone, as C11 and as C++17, and twice in one file. Prints TAP.
set -u
n=0

check() { # NAME COMPILER FLAG...
	local name=$1
	shift
	n=$((n + 1))
	if printf '#include <touchstone/%s>\n#include <touchstone/%s>\n' "$header" "$header" |
		"$@" -Wall -Wextra -Wpedantic -Werror -fsyntax-only -Iinclude -; then
		echo "ok $n - $header as $name"
	else
		echo "not ok $n - $header as $name"
	fi
}

for path in include/touchstone/*.h; do
	header=$(basename "$path")
	check C11 gcc -std=c11 -x c
	check C++17 g++ -std=c++17 -x c++
done
echo "1..$n"
