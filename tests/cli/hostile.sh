#!/bin/bash
# Every fourth file of the corpus of malformed and odd glTF, $TS_SCENES/hostile, through the command, or each with
# TS_HOSTILE=all: it ends within 10 seconds, with exit code 0 or 2, one line on stderr if 2 and none if 0, and a render
# leaves its folder or nothing. tests/scene/hostile.c loads every file.
. "$(dirname "$0")/tap.bash"
hostile=$(realpath -m "${TS_SCENES:-../shared/scenes}")/hostile
if [ ! -r "$hostile/manifest.tsv" ]; then
	echo "1..0 # skip $hostile is absent; set TS_SCENES"
	exit 0
fi
cd "$scratch" || exit 2
small=(--size 64x64 --reflectors 2 --set reflector_px=16 --set face_max=16 --threads 1)
wrong=0 n=0 every=$([ "${TS_HOSTILE:-}" = all ] && echo 1 || echo 4)

complain() {
	wrong=$((wrong + 1))
	echo "# $1: exit code $status: $(head -c 300 stderr)"
}

# behaves EXPECTED ARGUMENT...: "ok" asks for 0, "error" for 2, "either" for one of them.
behaves() {
	local expected=$1
	shift
	timeout 10 "$touchstone" "$@" > stdout 2> stderr < /dev/null
	status=$?
	case $expected-$status in
	ok-0 | either-0) [ ! -s stderr ] ;;
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
done < <(tail -n +2 "$hostile/manifest.tsv")
[ "$wrong" -eq 0 ] && [ "$n" -gt 100 ]
verdict $? "one in $every of $n files"

finish
