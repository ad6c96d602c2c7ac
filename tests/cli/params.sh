#!/bin/bash
# Which parameters a method reads: `list params --method`, and the line about those that a render sets in vain.
. "$(dirname "$0")/tap.bash"

# names ARGUMENT...: the parameters that are listed, a line each.
names() { "$touchstone" list params --json "$@" |
	python3 -c 'import json, sys; [print(p["name"]) for p in json.load(sys.stdin)["params"]]'; }

all=$(names)
epr=$(names --effect reflections --method epr)
grep -qx density.scale <<< "$epr" && grep -qx width <<< "$epr" &&
	! grep -qx 'pcss.near\|mvr.filter\|shadow_splat.rate' <<< "$epr"
verdict $? "EPR's parameters in reflections"
names --method epr | grep -x shadow_splat.rate > /dev/null
verdict $? "EPR's parameters in all effects"
! names --effect particles | grep -x view_map.field > /dev/null
verdict $? "what a method sets itself is not read"
[ -z "$(comm -13 <(sort <<< "$all") <(for effect in $("$touchstone" list methods --json |
	python3 -c 'import json, sys; print(*{m["effect"] for m in json.load(sys.stdin)["methods"]})'); do names \
	--effect "$effect"; done | sort -u))" ]
verdict $? "what is read is a parameter"
refuses 'no method "nix"' list params --method nix
refuses 'more than 16 methods; say --effect' list params \
	--method epr,mvr,ivir,vir,pcss,hulls,direct,megaviews,manylods,bruteforce,deferred
refuses 'the nearest is epr' list params --effect reflections --method erp
refuses 'takes no --method' list stages --method epr

tiny=(--size 32x18 --no-images --reflectors 1)
# says COUNT ARGUMENT...: a render of reflections works and says of so many parameters that none reads them.
says() {
	local wanted=$1
	shift
	run render reflections gallery:triangles=10000:texels=32 --set cube.max_px=16 "${tiny[@]}" "$@"
	[ "$status" -eq 0 ] && [ "$(grep -c 'reads it$' "$scratch/stderr")" -eq "$wanted" ] &&
		[ "$(wc -l < "$scratch/stderr")" -eq "$wanted" ]
	verdict $? "$wanted unread: $*"
}
says 0 --method mvr
says 0 --method mvr --set eye.fov=50 --set mvr.filter=supersample
says 1 --method mvr --set splat.clip=on
grep -q -- '--set splat.clip: ' "$scratch/stderr"
verdict $? "a parameter that is set to its default is named, too"
says 0 --method mvr,epr --set splat.clip=off
says 2 --method mvr --set splat.clip=off --set surfels.neighbours=3
says 1 --method mvr --set density.scale=1
says 0 --method mvr --set lookup.bounces=2 --truth=A
says 1 --method mvr --set splat.clip=on,off
says 1 --method mvr --set truth.area_samples=4
# gloss COUNT SETTING: as says, of a parameter that only stages of gloss.lobe=on read.
gloss() {
	run render indirect gallery:triangles=10000:texels=32 "${tiny[@]}" --method direct --set rsm.px=4 \
		--set hull.sharpness=vmf --set "$2"
	[ "$status" -eq 0 ] && [ "$(grep -c -- '--set hull.sharpness: .* reads it$' "$scratch/stderr")" -eq "$1" ]
	verdict $? "$1 unread: stages that run with $2"
}
gloss 1 gloss.lobe=off
gloss 0 gloss.lobe=on,off
run render soft-shadows gallery:triangles=10000:texels=32 "${tiny[@]}" --method pcss --set depth_map.px=32 \
	--set truth.area_samples=4 --set density.rate=exact --truth=area
[ "$status" -eq 0 ] && [ ! -s "$scratch/stderr" ]
verdict $? "a truth reads what its methods do not"
finish
