#!/bin/bash
# Every kernel header compiles alone as C11 and, by clang's front end, as OpenCL C 1.2. Prints TAP.
set -u
n=0

check() { # NAME COMPILER FLAG...
	local name=$1
	shift
	n=$((n + 1))
	if ! command -v "$1" >/dev/null; then
		echo "ok $n - $name # SKIP no $1"
	elif printf '#include "%s"\n' "${header#src/}" |
		"$@" -Iinclude -iquote src -fsyntax-only -Wall -Wextra -Werror -; then
		echo "ok $n - $name"
	else
		echo "not ok $n - $name"
	fi
}

for header in src/kernels/*/*.h; do
	check "$header as C11" gcc -std=c11 -Wno-unused-function -Wno-unused-const-variable -x c
	check "$header as OpenCL C 1.2" clang -x cl -cl-std=CL1.2 -Xclang -finclude-default-header -Wno-unused-function
done
echo "1..$n"
