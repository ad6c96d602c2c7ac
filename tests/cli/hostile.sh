#!/bin/bash
# Every fourth file of the corpus of malformed and odd glTF, $TS_SCENES/hostile, through the command, or each with
# TS_HOSTILE=all: it ends within 10 seconds, with exit code 0 or 2, one line on stderr if 2 and none if 0, and a render
# leaves its folder or nothing. Every twelfth also by MegaViews, whose parameters are taken to their ends and beyond.
# tests/scene/gltf/hostile.c loads every file.
. "$(dirname "$0")/tap.bash"
hostile=$(realpath -m "${TS_SCENES:-scenes}")/hostile
if [ ! -r "$hostile/manifest.tsv" ]; then
	echo "1..0 # skip $hostile is absent; set TS_SCENES"
	exit 0
fi
cd "$scratch" || exit 2
small=(--size 64x64 --reflectors 2 --set reflectors.px=16 --set cube.max_px=16 --threads 1)
views=(--size 32x32 --set octree.levels=5 --set rsm.px=4 --set particle.count=50 --threads 1)
wrong=0 n=0 every=$([ "${TS_HOSTILE:-}" = all ] && echo 1 || echo 4)

complain() {
	wrong=$((wrong + 1))
	echo "# $1: exit code $status: $(head -c 300 stderr)"
}

# The settings of `small` and `views` are not all read by each render, which says so.
is_quiet() { ! grep -qv '^touchstone: --set [a-z_.]*: no method, scene or truth of this render reads it$' stderr; }

# behaves EXPECTED ARGUMENT...: "ok" asks for 0, "error" for 2 before anything is printed, "either" for one of them.
behaves() {
	local expected=$1
	shift
	timeout 10 "$touchstone" "$@" > stdout 2> stderr < /dev/null
	status=$?
	case $expected-$status in
	ok-0 | either-0) is_quiet ;;
	error-2 | either-2) [ "$(wc -l < stderr)" -eq 1 ] && [ ! -s stdout ] ;;
	*) false ;;
	esac
}

while IFS=$'\t' read -r file expected _; do
	n=$((n + 1))
	[ $((n % every)) -eq 0 ] || continue
	behaves "$expected" render reflections "$hostile/$file" "${small[@]}" -o out || complain "render $file"
	if [ "$status" -eq 0 ]; then
		[ -s out/epr.png ] && [ -s out/mvr.png ] && [ ! -e out.partial ] || complain "pictures of $file"
		rm -rf out
		behaves ok info "$hostile/$file" || complain "info $file"
	fi
	[ "$(ls)" = $'stderr\nstdout' ] || complain "left behind by $file"
	rm -rf out out.partial
	[ $((n % (3 * every))) -eq 0 ] || continue
	for words in 'indirect megaviews' 'particles manylods'; do
		read -r effect method <<< "$words"
		behaves "$expected" render "$effect" "$hostile/$file" "${views[@]}" --method "$method" -o out ||
			complain "render $effect $file"
		[ "$status" -eq 2 ] || [ -s "out/$method.png" ] || complain "picture of $effect $file"
		rm -rf out
		[ "$(ls)" = $'stderr\nstdout' ] || complain "left behind by $effect $file"
	done
done < <(tail -n +2 "$hostile/manifest.tsv")
[ "$wrong" -eq 0 ] && [ "$n" -gt 100 ]
verdict $? "one in $every of $n files"

# octree.levels=11, and the most views, are right, and take longer.
wrong=0
while read -r expected effect setting; do
	behaves "$expected" render "$effect" atrium:triangles=10000:texels=32 "${views[@]}" --method megaviews --set "$setting" -o out ||
		complain "$effect $setting"
	rm -rf out out.partial
done <<'END'
ok indirect octree.levels=1
error indirect octree.levels=0
error indirect octree.levels=12
ok indirect vpl.paths=1
error indirect vpl.paths=16777217
ok indirect view_map.px=4
ok indirect view_map.px=1024
error indirect view_map.px=48
error indirect view_map.px=2
error indirect view_map.px=2048
ok indirect traverse.queue_mb=1
error indirect traverse.queue_mb=0
error indirect traverse.queue_mb=65537
ok indirect vpl_gather.level=0
ok indirect vpl_gather.level=11
error indirect vpl_gather.level=12
ok indirect bilateral.px=64
ok particles particle.count=1
error particles particle.count=0
error particles particle.count=16777217
error particles particle.glow=-1
END
[ "$wrong" -eq 0 ]
verdict $? 'parameters of MegaViews at their ends and beyond'

finish
