#!/bin/bash
# include/touchstone/candidate.h writes what ours are: a candidate of a trace's own buffers, held as a port holds them,
# has the same files; and a program that uses it works in C99 and in C++11.
. "$(dirname "$0")/../cli/tap.bash"
. "$(dirname "$0")/ports.bash"

# copied METHOD TRACE FILES: a copy of the trace, of more files than that, is the same.
copied() {
	rm -rf "$scratch/copy" && mkdir "$scratch/copy"
	"${BUILD:-build/release}/tests/ports/candidate" copy "$2" "$scratch/copy"
	verdict $? "$1: a candidate of every buffer"
	run compare "$2" "$scratch/copy"
	[ "$status" -eq 0 ] && grep -q ' 0 different, 0 missing' "$scratch/stdout"
	verdict $? "$1: which compare finds the same"
	for file in "$scratch"/copy/*.npy; do
		cmp "$file" "$2/"??-"${file##*/}"
	done > "$scratch/files" 2>&1
	[ ! -s "$scratch/files" ] && [ "$(ls "$scratch"/copy/*.npy | wc -l)" -gt "$3" ]
	verdict $? "$1: file for file"
}

trace whole atrium:triangles=10000:texels=32 --size 96x54 --reflectors 2 --set reflectors.px=30 --set cube.max_px=64
copied 'reflections epr' "$scratch/whole/trace-epr" 30
shadows=(atrium:triangles=10000:texels=32 --size 96x54 --reflectors 0 --set lamp.views=5 --set lamp.cubes=2
	--set depth_map.px=24 --trace --no-images)
for words in 'soft-shadows ivir' 'omni-shadows epr'; do
	read -r effect method <<< "$words"
	run render "$effect" "${shadows[@]}" --method "$method" --set points.buffered=on -o "$scratch/$effect"
	copied "$words" "$scratch/$effect/trace-$method" 25
done

cat > "$scratch/example.c" << 'END'
#include <touchstone/candidate.h>
int main(int argc, char **argv)
{
	static const uint64_t texels[2] = {0, 1};
	uint64_t shape[1] = {2};
	ts_candidate c;
	ts_candidate_begin(&c, argv[argc - 1], "epr", "canonical", "my port", "0.3");
	ts_candidate_param(&c, "density.scale", "0.5");
	ts_candidate_param(&c, "splat.clip", "off");
	ts_candidate_add(&c, "splat.depth_index", 1, shape, texels);
	if (ts_candidate_end(&c) != 0) fprintf(stderr, "%s\n", c.message);
	return c.message[0] != 0;
}
END
cp "$scratch/example.c" "$scratch/example.cc"
strict=(-O1 -Wall -Wextra -Wpedantic -Wshadow -Werror -Iinclude)
for language in 'gcc -std=c99 example.c' 'g++ -std=c++11 example.cc' 'clang -std=c99 example.c' \
	'clang++ -std=c++11 example.cc'; do
	read -r compiler standard source <<< "$language"
	mkdir -p "$scratch/example"
	"$compiler" "$standard" "${strict[@]}" "$scratch/$source" -o "$scratch/program" &&
		"$scratch/program" "$scratch/example" && run compare "$scratch/example" "$scratch/example"
	grep -q '^1 buffers judged' "$scratch/stdout" && grep -q '"splat.clip": "off"' "$scratch/example/trace.json"
	verdict $? "the header in $language"
done

"$scratch/program" "$scratch/nowhere" 2> "$scratch/stderr"
[ $? -eq 1 ] && grep -q 'nowhere/splat.depth_index.npy: cannot be written' "$scratch/stderr"
verdict $? 'a folder that is not there'

finish
