#!/bin/bash
# Flags on make's command line are added to the project's own, never in their place, and warnings are errors on demand
# only. Compiles nothing: looks at the commands that make would run. Prints TAP.
set -u
n=0

# has NAME SOURCE PATTERN...: the command that compiles or links it has all of these.
has() {
	local name=$1 line pattern good=0
	line=$(grep -e "$2" <<< "$commands" | head -n 1)
	shift 2
	for pattern in "$@"; do
		grep -q -e "$pattern" <<< "$line" || good=1
	done
	n=$((n + 1))
	if [ "$good" -eq 0 ]; then echo "ok $n - $name"; else echo "not ok $n - $name"; fi
}

# every NAME LINES PATTERN: there are commands that match LINES, and all of them match PATTERN.
every() {
	local good=0
	grep -q -e "$2" <<< "$commands" && ! grep -e "$2" <<< "$commands" | grep -v -e "$3" || good=1
	n=$((n + 1))
	if [ "$good" -eq 0 ]; then echo "ok $n - $1"; else echo "not ok $n - $1"; fi
}

would() {
	env -u WERROR -u MAKEFLAGS -u MAKELEVEL make -n V=1 JOBS=1 BUILD=build/none "$@" all 2> /dev/null
}

commands=$(would CPPFLAGS=-DTRIED CFLAGS=-g3 CXXFLAGS=-g2 LDFLAGS=-Wl,-O1)
has 'the OpenCL program' '-c src/backends/opencl/program.c' -DTRIED -g3 '-Ibuild/none/gen' '-ffp-contract=off'
has 'what a trace says of its maker' '-c src/backends/c/run.c' -DTRIED -g3 '-DTS_FLAGS='
has 'the commit' '-c src/model/commit.c' -DTRIED -g3 '-DTS_COMMIT='
has 'C++' '-c src/scene/gltf/gltf.cc' -DTRIED -g2 '-std=c++17'
has 'linking' '-o build/none/touchstone$' '-Wl,-O1' '-ljansson'

# What a packager says in the environment; what the contract asks for stands behind it.
commands=$(CPPFLAGS=-DTRIED CFLAGS=-g3 CXXFLAGS=-g3 LDFLAGS=-Wl,-O1 would \
	build/none/touchstone-core build/none/installed/touchstone build/none/tests/model/error \
	build/none/record/touchstone)
every 'all that is compiled' ' -c [^ ]* -o ' '-DTRIED -g3 .*-ffp-contract=off -fno-math-errno -fno-trapping-math'
every 'all that is linked' '\.[ao] .* -o build/none/' '-Wl,-O1'

n=$((n + 1))
if ! grep -q -e -Werror <<< "$commands"; then echo "ok $n - warnings are warnings"; else echo \
	"not ok $n - warnings are warnings"; fi
commands=$(would WERROR=1)
has 'unless WERROR is 1' '-c src/model/commit.c' -Werror

# x87 is refused, by one line that says what would be right; only where the compiler is one for x86.
if [ "$(uname -m)" = x86_64 ]; then
	said=$(env -u MAKEFLAGS -u MAKELEVEL -u config make -n OPT='-O2 -mfpmath=387' core 2>&1 > /dev/null)
	n=$((n + 1))
	good=0
	[ "$(wc -l <<< "$said")" -eq 1 ] && grep -q 'x87: .* -msse2 -mfpmath=sse" would be right' <<< "$said" || good=1
	if [ "$good" -eq 0 ]; then echo "ok $n - x87 is refused"; else echo "not ok $n - x87 is refused"; fi
fi
echo "1..$n"
