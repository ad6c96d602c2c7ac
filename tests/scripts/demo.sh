#!/bin/bash
# `make demo` first builds what a picture takes, and says what it leaves out; it takes nothing from a whole build.
# Compiles nothing: looks at the commands that make would run. Prints TAP.
set -u
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT
n=0

would() {
	commands=$(env -u WERROR -u MAKEFLAGS -u MAKELEVEL TS_INSTALL=0 make -n V=1 JOBS=1 BUILD="$build" "$@" 2>&- |
		sed -e ':a' -e '/\\$/N; s/\\\n[[:space:]]*//; ta')
}

# verdict NAME: of the command before.
verdict() {
	local good=$?
	n=$((n + 1))
	if [ "$good" -eq 0 ]; then echo "ok $n - $1"; else echo "not ok $n - $1"; fi
}

# has PATTERN...: the commands have each.
has() {
	local pattern
	for pattern in "$@"; do
		grep -q -e "$pattern" <<< "$commands" || return 1
	done
}
once_more='scripts/glsl --guarded\|scripts/explained\|scripts/ptx\|\.spv'

would demo
has '-o .*/touchstone$' 'build/touchstone render reflections atrium' && ! has "$once_more"
verdict 'the first build compiles no kernel once more'
tail -n 1 <<< "$commands" | grep -q 'left out: the kernels of vulkan cuda explain; .*make.* builds them'
verdict 'and the last line says so'
page=$(sed -n 's/.*render reflections atrium.* --report \([^ ]*\)$/\1/p' <<< "$commands")
[ -n "$page" ] && grep -q "\`$page\`" README.md
verdict "README names the page, $page"

mkdir "$build/gen" && echo > "$build/gen/devices"
would all
has scripts/glsl scripts/explained && ! has 'left out'
verdict 'a later make builds the rest'
has "cmp -s - $build/gen/devices" "cmp -s - $build/flags"
verdict 'every make asks whether its switches have changed'
echo vulkan cuda explain > "$build/gen/devices"
would demo
has scripts/glsl scripts/explained 'build/touchstone render' && ! has 'left out'
verdict 'a demo behind a whole build keeps that whole'
echo "1..$n"
