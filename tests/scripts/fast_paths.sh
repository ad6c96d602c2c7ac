#!/bin/bash
# scripts/fast-paths leaves out the fast paths of edited kernels, and no others: a comment is no edit, a function that
# the kernel calls and a macro that it reads are. No fast path of the tree is left out. Prints TAP.
. "$(dirname "$0")/../cli/tap.bash"
cp -r --parents scripts/fast-paths src/kernels src/backends src/families.def include/touchstone/records.def "$scratch"
make_inc=$(realpath "${BUILD:-build/release}")/gen/fast.inc
cd "$scratch" || exit 2

# leaves_out KERNELS NAME: what the script says, and the rows of that many kernels.
leaves_out() {
	scripts/fast-paths rows > said 2>&1
	[ $? -eq 0 ] && [ "$(sed -n 's/^left out: the fast paths of \(.*\): these .*/\1/p' said)" = "$1" ] &&
		[ "$(grep '^EDITED' rows | sed 's/EDITED(\(.*\))/\1/' | paste -sd' ' | sed 's/ /, /g')" = "$1" ] &&
		[ "$(wc -l < rows)" -eq "$n_rows" ]
	verdict $? "$2"
}
# edits PATTERN FILE: by sed, which must change the file.
edits() { sed "$1" "$2" > edited && ! cmp -s edited "$2" && mv edited "$2"; }

n_rows=$(grep -cE '^(FAST|AT_ONCE)\(' src/backends/c/*/fast.def | awk -F: '{ n += $2 } END { print n }')
leaves_out '' 'no kernel of the tree has another text than its fast path was written for'
! grep -q EDITED "$make_inc" && cmp -s rows "$make_inc"
verdict $? 'and the build has all fast paths'
edits '$a /* A comment. */' src/kernels/points/splat_box.h &&
	edits 's/half_length = length/half_length  =  length/' src/kernels/points/splat_box.h
leaves_out '' 'comments and spaces are no edit'
cp src/kernels/points/splat_box.h before
edits 's/length \* 0\.5f/length * 0.25f/' src/kernels/points/splat_box.h
leaves_out 'splat, splat_fragments, shadow_splat_pieces' 'a function that three kernels call'
cp before src/kernels/points/splat_box.h
cp src/kernels/views/pair.h before
edits 's/ < apart \* s->r/ <= apart * s->r/' src/kernels/views/pair.h
leaves_out 'vpl_gather_pairs_count, vpl_gather_pairs_list, view_map' \
	'what a traversal decides, where that is done at once'
cp before src/kernels/views/pair.h
edits 's/^\(#define TS_A_LITTLE\) .*/\1 0.125f/' src/kernels/surfels/surfel_setup.h
leaves_out 'surfel_setup' 'a macro'
edits 's/ARG(VALUE, u32, n_pieces, none)/ARG(VALUE, u64, n_pieces, none)/' src/kernels/points/splat.h
leaves_out 'splat, splat_fragments, surfel_setup' 'an argument'
scripts/fast-paths --write
leaves_out '' '--write takes them back'
if command -v clang > found; then
	CC=clang leaves_out '' 'clang reads the same text'
fi
sed -i 's/ts_k_hull_item/ts_k_hulk_item/' src/kernels/hulls/hull.h
scripts/fast-paths rows > said 2>&1
[ $? -eq 2 ] && grep -qx 'fast-paths: hull: no ts_k_hull_item in src/kernels' said
verdict $? 'a kernel that is gone is named'
echo '#error no text' >> src/kernels/base/vec.h
scripts/fast-paths rows > said 2>&1
[ $? -eq 2 ] && grep -q 'no text' said
verdict $? 'a text that cannot be read is an error'
finish
