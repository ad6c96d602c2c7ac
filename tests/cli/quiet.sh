#!/bin/bash
# With -q what passes prints nothing, and of what fails only that is told;
# JSON, TAP, files and exit codes stay as they are.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
cd "$scratch" || exit 2
export OMP_WAIT_POLICY=passive

# silent ARGUMENT...: exit code 0, and nothing is printed, though without -q there is.
silent() {
	run "$@"
	[ "$status" -eq 0 ] && [ -s stdout ] && run "$@" -q ${again:-} && [ "$status" -eq 0 ] && [ ! -s stdout ] &&
		[ ! -s stderr ]
	verdict $? "silent: $*"
}
# tells N PATTERN ARGUMENT...: exit code 1 and N lines, of which one matches.
tells() {
	local n=$1 pattern=$2
	shift 2
	run "$@" --quiet
	[ "$status" -eq 1 ] && [ "$(wc -l < stdout)" -eq "$n" ] && grep -q -- "$pattern" stdout && [ ! -s stderr ]
	verdict $? "$n lines: $*"
}
# stays ARGUMENT...: prints the same with -q.
stays() {
	run "$@"
	mv stdout before
	run "$@" -q
	cmp -s stdout before
	verdict $? "stays: $*"
}
# wrong FILE OFFSET: another byte, counted from the end.
wrong() {
	/usr/bin/python3 - "$@" <<'PY'
import sys
data = bytearray(open(sys.argv[1], "rb").read())
data[-int(sys.argv[2])] ^= 1
open(sys.argv[1], "wb").write(data)
PY
}

again=--force silent "${frame[@]}" --method epr --trace -o r
silent "${frame[@]}" --method mvr --set seed=1,2
cp -r r/trace-epr c
silent compare r/trace-epr c
silent replay r/trace-epr
wrong c/05-mirror_pixel.record.npy 24
wrong c/20-image.srgb.npy 40
tells 3 '^different  image  stage 20 image, buffer image.srgb, pixel' compare r/trace-epr c
tells 2 '^stage 05 mirror_pixel, buffer mirror_pixel.record: different' replay c
tells 1 '^stage 20 image, buffer image.srgb: different' replay c --stage image
stays compare r/trace-epr c --tap
stays compare r/trace-epr c --json
for i in 1 2; do run compare r/trace-epr c --shard $i/2 -o s-$i -q; done
tells 3 '^different  image' merge s-1 s-2

mkdir goldens
for i in 1 2; do
	echo "case-$i: mvr dining:triangles=10000:texels=32 --size 24x16 --reflectors 0 --set seed=$i --small"
done > goldens/cases.txt
run golden new --goldens goldens
accepts goldens case-{1,2}
golden=(golden check --goldens goldens)
silent "${golden[@]}"
wrong goldens/case-2/small/*-image.srgb.npy 7
tells 1 '^different  case-2  ' "${golden[@]}"
stays "${golden[@]}" --json

run vectors -o v
silent vectors --check v
wrong v/dot.out.npy 5
run vectors --check v -q
[ "$status" -eq 1 ] && head -n 1 stdout | grep -q '^dot, item 4094, the first of 1 wrong' && ! grep -q right stdout
verdict $? 'of vectors what is wrong'
refuses 'no option -q' list stages -q
finish
