#!/bin/bash
# scripts/house finds nothing wrong with the tree, and sees what it is for: arrows upward, nouns without a test.
# Prints TAP.
set -u
house=$(realpath scripts/house)
export TOUCHSTONE=$(realpath "${TOUCHSTONE:-build/touchstone}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
n=0

result() { # GOOD NAME
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then
		echo "ok $n - $2"
	else
		echo "not ok $n - $2"
		sed 's/^/# /' "$folder/out"
	fi
}

# gives STATUS TEXT NAME COMMAND...: the command's exit status, and a line that it prints.
gives() {
	local status=$1 text=$2 name=$3
	shift 3
	"$@" > "$folder/out" 2>&1
	[ $? -eq "$status" ] && grep -qF -- "$text" "$folder/out"
	result $? "$name"
}

for check in rooms clients rebuilt nouns sets includes; do
	"$house" "$check" > "$folder/out" 2>&1
	result $? "the tree itself: $check"
done
find "${BUILD:-build/release}/obj/src" -name '*.o' -exec nm -A {} + > "$folder/symbols"
! grep ' i ' "$folder/symbols" && grep -q '_of_any_width\|_of_16\|_of_4' "$folder/symbols" ||
	[ "$(uname -m)" != x86_64 ]
result $? "loops for vectors are not chosen by the loader"
grep -E '\.c\.o: +U (__isoc[0-9]+_)?(strto(f|d|ld)|atof)$' "$folder/symbols" |
	grep -v '/model/decimal\.c\.o' > "$folder/out"
[ ! -s "$folder/out" ]
result $? "floats in texts are read by model/decimal.c alone, whatever the locale"
sed -E 's/.*"(.*)".*/\1/' <(tr ')' '\n' < "${BUILD:-build/release}/gen/tests.inc") | grep . |
	sed "s|.*|${BUILD:-build/release}/obj/tests/&.c.o|" |
	xargs nm -P --defined-only | awk '$2 ~ /^[TDBRVW]$/ { print $1 }' | sort -u > "$folder/own"
{ nm -DP --defined-only $(ldconfig -p | awk '/lib(c|m)\.so\.6 / { print $NF }'); nm -P \
	--defined-only "${BUILD:-build/release}/libtouchstone.a"; } \
	2> "$folder/nm" | awk '$2 ~ /^[TDBRVWi]$/ { print $1 }' | sed 's/@.*//' | sort -u |
	comm -12 - "$folder/own" > "$folder/out"
[ "$(wc -l < "$folder/own")" -gt 300 ] && [ ! -s "$folder/out" ]
result $? "no test of the one program defines what libc or the library has"

mkdir -p "$folder"/tree/src/{model,trace,cli} "$folder"/tree/obj/src/{model,trace,cli}
cd "$folder/tree" || exit
printf '#include FAMILY(%s)\n' raster points another > src/families.def
echo '#include "trace/b.h"' > src/model/a.h
echo '#include "model/a.h"' > src/trace/b.h
printf 'int upper(void);\nint lower(void) { return upper(); }\n' > src/model/a.c
printf 'int upper(void) { return 0; }\n' > src/cli/c.c
for source in src/*/*.c; do ${CC:-gcc} -iquote src -c "$source" -o "obj/$source.o"; done
BUILD=. gives 1 "upward: model -> trace" "an include line that goes up a floor" "$house" rooms
BUILD=. gives 1 "circle: model trace" "rooms that include each other" "$house" rooms
BUILD=. gives 1 "src/model/a.c -> src/cli/c.c" "a symbol of a floor above" "$house" rooms
mkdir -p include/touchstone
echo 'TS_API int ts_asked(void);' > include/touchstone/a.h
echo 'struct context;' > src/cli/client.h
echo '#include "cli/client.h"' > src/cli/own.h
printf '#include "cli/own.h"\nint ts_hidden(void);\nint g(void) { return ts_hidden(); }\n' > src/cli/g.c
printf 'int ts_asked(void) { return 1; }\nint ts_hidden(void) { return 0; }\n' > src/trace/asked.c
for source in src/cli/g.c src/trace/asked.c; do ${CC:-gcc} -iquote src -c "$source" -o "obj/$source.o"; done
BUILD=. gives 1 "g.c: ts_hidden of src/trace/asked.c" "a client that needs what no public header has" "$house" clients
printf '#include "cli/own.h"\nint ts_asked(void);\nint g(void) { return ts_asked(); }\n' > src/cli/g.c
${CC:-gcc} -iquote src -c src/cli/g.c -o obj/src/cli/g.c.o
BUILD=. gives 0 "1 of 2 files" "a client of the public headers" "$house" clients
echo '#include "trace/b.h"' >> src/cli/g.c
BUILD=. gives 1 "g.c: trace/b.h" "a client that includes a room's header" "$house" clients
rm src/cli/g.c src/cli/own.h src/trace/asked.c
echo '#include "model/a.h"' > src/cli/b.h
rm src/trace/b.h src/model/a.c
BUILD=. gives 0 "by symbol: 0 arrows" "rooms in order" "$house" rooms
mkdir -p src/kernels/{points,another,raster}
: > src/kernels/points/d.h
echo '#include "kernels/points/d.h"' > src/kernels/another/e.h
BUILD=. gives 1 "between families: kernels/another -> kernels/points" "an arrow between families" "$house" rooms
mv src/kernels/{points,raster}/d.h
echo '#include "kernels/raster/d.h"' > src/kernels/another/e.h
BUILD=. gives 0 "0 between families" "what all families share" "$house" rooms
rm -r src/kernels

mkdir -p src/kernels/{points,raster} src/methods tests/kernels
: > src/kernels/points/lookup.h > src/kernels/raster/draw.h
for i in $(seq 65); do
	: > "src/model/$i.c"
	lookup=$([ "$i" -gt 30 ] || echo src/kernels/points/lookup.h)
	echo "obj/$i.o: src/model/$i.c $lookup src/model/../kernels/raster/draw.h" > "obj/src/model/$i.d"
done
BUILD=. gives 1 "  30  src/kernels/points/lookup.h  (fewer than 30 wanted)" "a kernel that rebuilds too much" \
	"$house" rebuilt
BUILD=. gives 1 "  65  src/kernels/raster/draw.h  (fewer than 65 wanted)" "a rasterizer that does" "$house" rebuilt
rm src/model/30.c
BUILD=. gives 0 "0 headers rebuild too many of 64 sources" "headers that do not" "$house" rebuilt
BUILD=. gives 0 "  29  src/kernels/points/lookup.h" "a header that is right is shown by --all" "$house" --all rebuilt

printf 'const ts_stage ts_stage_lookup_second = {\n\t.launches = TS_LAUNCHES(&first),\n};\n' > src/methods/lookup.c
gives 1 "lookup            kernels  methods  -        lookup.second" "a noun without a test of its name" "$house" nouns
: > tests/kernels/lookup.c
gives 0 "1 of 1 are in all" "a noun with kernel, body and test of its name" "$house" nouns

mkdir -p src/methods/points tests/methods/points
echo 'STAGE(align)' > src/methods/points/family.def
gives 1 "+align: reads " "a stage whose sets no file has" "$house" sets
"$house" --write sets > "$folder/out"
gives 0 "sets: 0 families" "sets that were written" "$house" sets
sed -i 's/; writes.*/; writes eye.view/' tests/methods/points/sets.txt
gives 1 "writes eye.view" "a stage that writes another buffer" "$house" sets
gives 2 "usage: scripts/house" "a check that there is not" "$house" roms

rm -r src tests include && mkdir -p src/{model,trace} tests/trace include/touchstone
guarded() { printf '#ifndef %s\n#define %s\n#endif\n' "$1" "$1"; }
guarded TS_MODEL_A_H > src/model/a.h
guarded TS_TRACE_B_H > src/trace/b.h
guarded TS_TESTS_TRACE_B_H > tests/trace/b.h
guarded TOUCHSTONE_C_H > include/touchstone/c.h
printf '#include %s\n' '"model/a.h"' '<stdio.h>' '<touchstone/c.h>' '"made.inc"' '"trace/b.h"' > src/model/a.c
printf '#include %s\n' '<stdio.h>' '"model/a.h"' '"tests/trace/b.h"' > tests/trace/d.c
gives 0 "includes: 0 faults in 6 files with 5 names" "includes by the rules" "$house" includes

# planted TEXT NAME FILE: the file, which standard input holds, is refused by that line, and no other.
planted() {
	cp "$3" "$folder/kept" 2> "$folder/out" || rm -f "$folder/kept"
	cat > "$3"
	gives 1 "includes: 1 faults" "$2" "$house" includes
	gives 1 "$3: $1" "and its line" "$house" includes
	mv "$folder/kept" "$3" 2> "$folder/out" || rm "$3"
}
planted '"../trace/b.h" is no path' "a header that is named from its folder" src/model/e.c <<< '#include "../trace/b.h"'
planted '"b.h" is no path' "one of the same folder" src/trace/e.c <<< '#include "b.h"'
planted '"tests/trace/b.h" is no path' "one of the tests in a source" src/trace/e.c <<< '#include "tests/trace/b.h"'
mkdir -p src/model/trace && guarded TS_MODEL_TRACE_B_H > src/model/trace/b.h
planted '"trace/b.h" is no path' "one that is hidden" src/model/a.c <<< '#include "trace/b.h"'
rm -r src/model/trace
planted '"model/a.h" would stand before <stdio.h>' "a file whose own header is not the first" src/model/a.c \
	< <(printf '#include %s\n' '<stdio.h>' '"model/a.h"')
planted '<math.h> would stand before <stdio.h>' "includes that are not by the alphabet" src/model/a.c \
	< <(printf '#include %s\n' '<stdio.h>' '<math.h>')
planted '<stdio.h> would stand before "model/a.h"' "quotes before <>" tests/trace/d.c \
	< <(printf '#include %s\n' '"model/a.h"' '<stdio.h>')
planted 'the guard TS_TRACE_B_H would be right' "a guard of another path" src/trace/b.h < <(guarded TS_CORE_B_H)
planted 'the guard TOUCHSTONE_C_H would be right' "a public header without one" include/touchstone/c.h <<< 'int c;'
echo "1..$n"
