#!/bin/bash
# The printed pseudo-code of the kernels, run in Python with NumPy's float32 on what explained items were given, has the
# bits of the kernels: of each function of numbers alone, and of all that an item stores.
. "$(dirname "$0")/../cli/tap.bash"
. "$(dirname "$0")/../ports/ports.bash"
find_numpy || exit 0
scripts/pseudocode "$scratch/printed"
verdict $? 'scripts/pseudocode writes it'
awk '/^def / { split("", seen) } { text = $0; sub(/^ +/, "", text) } $1 == "#" && seen[text]++ { print text }' \
	"$scratch"/printed/*/*.py > "$scratch/twice"
sed 's/^/# /' "$scratch/twice"
[ ! -s "$scratch/twice" ]
verdict $? 'the titles in a function are printed once'
check=$PWD/tests/kernels/pseudocode.py
cd "$scratch" || exit 2

# traces FOLDER OPTION...: small ones.
traces() {
	local folder=$1
	shift
	"$touchstone" render "$@" --size 32x24 --self-contained --no-images -o "$folder" > /dev/null
}
scene=atrium:triangles=10000:texels=32
traces a reflections $scene --method epr,mvr,epr-forward --reflectors 2 --set reflectors.px=12 --set cube.max_px=16 \
	--set lookup.bounces=3
traces b soft-shadows $scene --method ivir,pcss --set lamp.views=5 --set depth_map.px=24 --set lamp.source=scene
traces c indirect $scene --method hulls,megaviews --set rsm.px=4 --set depth_grid.px=64 --set octree.levels=3 \
	--set view_map.px=4 --set vpl.paths=20 --set lamp.source=scene
traces d surfels checkerboard:surfels=10000 --method deferred,phong
[ "$(ls -d ./*/trace-* | wc -l)" -eq 9 ]
verdict $? 'traces of nine methods'

# What comes before any method is the same in all of a folder.
for trace in */trace-*; do
	for stage in $("$touchstone" replay "$trace" | sed 's/^stage [0-9]* \([^ :,]*\).*/\1/'); do
		to=$trace/$stage.json
		[[ $stage =~ ^(eye|eye.view|pose|cube_size|mirror_pixel)$ ]] &&
			compgen -G "${trace%%/*}/*/$stage.json" > said && continue
		"$touchstone" explain "$trace" --stage "$stage" --item 401 --primitives --json > "$to" 2> /dev/null &&
			echo "$trace $to"
	done
done > pairs
"$python" "$check" printed pairs > stdout
verdict $? 'functions and items have the same bits'
sed 's/^/# /' stdout
read -r functions _ calls _ kernels _ < stdout
[ "$functions" -gt 150 ] && [ "$calls" -gt 10000 ] && [ "$kernels" -gt 40 ]
verdict $? 'most of the functions of numbers alone, and most kernels'

# plants FUNCTION FILE FROM TO: with a change to its text, the function is named.
plants() {
	cp -r printed damaged
	sed -i "/^def $1(/,/^\$/s/$3/$4/" "damaged/$2"
	! cmp -s "printed/$2" "damaged/$2" && ! "$python" "$check" damaged pairs > /dev/null 2> stderr &&
		grep -q "^$1" stderr
	verdict $? "a planted fault is named: $1"
	rm -r damaged
}
plants ts_dot base/vec.py 'x + y' 'x - y'
plants ts_k_snap raster/snap.py 8 9
finish
