#!/bin/bash
# Every fourth of the hostile files that tests/scene/open/hostile_files.py makes, through the command, or each with
# TS_HOSTILE=all: it ends within a minute, with exit code 0 or 2, one line on stderr if 2 and none if 0, and a render
# leaves its folder or nothing. Every twelfth also by MegaViews, whose parameters are taken to their ends and beyond.
# tests/scene/open/hostile.c loads every file.
. "$(dirname "$0")/tap.bash"
made=$(mktemp -d)
trap 'rm -rf "$scratch" "$made"' EXIT
/usr/bin/python3 tests/scene/open/hostile_files.py "$made" || exit 2
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

# behaves EXPECTED ARGUMENT...: "ok" asks for 0, "refused" for 2 before anything is printed, and $words in the line.
behaves() {
	local expected=$1
	shift
	timeout 60 "$touchstone" "$@" > stdout 2> stderr < /dev/null
	status=$?
	case $expected-$status in
	ok-0) is_quiet ;;
	refused-2) [ "$(wc -l < stderr)" -eq 1 ] && [ ! -s stdout ] && grep -qF -- "$words" stderr ;;
	*) false ;;
	esac
}

while IFS=$'\t' read -r file expected words; do
	n=$((n + 1))
	[ "$expected" = refused ] || expected=ok
	[ $((n % every)) -eq 0 ] || continue
	if [ "${file##*.}-$expected" = ply-ok ]; then # surfels, which these methods do not draw
		behaves ok info "$made/files/$file" || complain "info $file"
		continue
	fi
	behaves "$expected" render reflections "$made/files/$file" "${small[@]}" -o out || complain "render $file"
	if [ "$status" -eq 0 ]; then
		[ -s out/epr.png ] && [ -s out/mvr.png ] && [ ! -e out.partial ] || complain "pictures of $file"
		rm -rf out
		behaves ok info "$made/files/$file" || complain "info $file"
	fi
	[ "$(ls)" = $'stderr\nstdout' ] || complain "left behind by $file"
	rm -rf out out.partial
	[ $((n % (3 * every))) -eq 0 ] || continue
	for of in 'indirect megaviews' 'particles manylods'; do
		read -r effect method <<< "$of"
		behaves "$expected" render "$effect" "$made/files/$file" "${views[@]}" --method "$method" -o out ||
			complain "render $effect $file"
		[ "$status" -eq 2 ] || [ -s "out/$method.png" ] || complain "picture of $effect $file"
		rm -rf out
		[ "$(ls)" = $'stderr\nstdout' ] || complain "left behind by $effect $file"
	done
done < "$made/manifest.tsv"
[ "$wrong" -eq 0 ] && [ "$n" -gt 300 ]
verdict $? "one in $every of $n files"

# octree.levels=11, and the most views, are right, and take longer.
wrong=0 words=
while read -r expected effect setting; do
	behaves "$expected" render "$effect" atrium:triangles=10000:texels=32 "${views[@]}" --method megaviews \
		--set "$setting" -o out ||
		complain "$effect $setting"
	rm -rf out out.partial
done <<'END'
ok indirect octree.levels=1
refused indirect octree.levels=0
refused indirect octree.levels=12
ok indirect vpl.paths=1
refused indirect vpl.paths=16777217
ok indirect view_map.px=4
ok indirect view_map.px=1024
refused indirect view_map.px=48
refused indirect view_map.px=2
refused indirect view_map.px=2048
ok indirect traverse.queue_mb=1
refused indirect traverse.queue_mb=0
refused indirect traverse.queue_mb=65537
ok indirect vpl_gather.level=0
ok indirect vpl_gather.level=11
refused indirect vpl_gather.level=12
ok indirect bilateral.px=64
ok particles particle.count=1
refused particles particle.count=0
refused particles particle.count=16777217
refused particles particle.glow=-1
END
[ "$wrong" -eq 0 ]
verdict $? 'parameters of MegaViews at their ends and beyond'

finish
