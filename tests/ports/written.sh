#!/bin/bash
# Ports written from the installed documents alone: equal bits, and each of their questions has its answer in a document.
. "$(dirname "$0")/../cli/tap.bash"
. "$(dirname "$0")/ports.bash"
find_numpy || exit 0

# same FOLDER STAGES EFFECT SCENE OPTION...: the port has the bits of its stages.
same() {
	local folder=$1 stages=$2 method
	shift 2
	rm -rf "$scratch/made" "$scratch/mine"
	run render "$@" --size 64x48 --trace --no-images -o "$scratch/made"
	method=$(basename "$scratch"/made/trace-*)
	"$python" "tests/ports/$folder/port.py" "$scratch/made/$method" "$scratch/mine" && run compare "$scratch/made/$method" "$scratch/mine"
	[ "$status" -eq 0 ] && grep -q "^$stages buffers judged, 0 different" "$scratch/stdout"
	verdict $? "$folder: $*"
}

# answered FOLDER: the words behind each "Answered" stand in the document that is named there.
answered() {
	python3 - "tests/ports/$1/QUESTIONS.md" <<'PY'
import re, sys
text = open(sys.argv[1], encoding="utf-8").read()
answers = re.findall(r"\*Answered\* (\w+\.md): ([^\n]+(?:\n   (?!\*)[^\n]+)*)", text)
assert len(answers) == len(re.findall(r"^\d+\. ", text, re.M)) > 5, len(answers)
for document, words in answers:
	held = " ".join(open("reference/" + document, encoding="utf-8").read().split())
	assert " ".join(words.split()) in held, f"{document}: {words}"
PY
	verdict $? "$1: each question has its answer"
}

same surfels 3 surfels checkerboard:surfels=10000 --method deferred
same surfels 3 surfels atrium:triangles=10000 --from-mesh 12000 --method deferred --set surfels.radius=20 --eye 0,2,0
same surfels 3 surfels checkerboard:surfels=10000 --method ewa
same surfels 3 surfels checkerboard:surfels=10000 --method deferred --set surfel_setup.bounds=botsch --set ewa.filter=screen
answered surfels
same hulls 2 indirect atrium:triangles=10000 --method hulls
same hulls 2 indirect atrium:triangles=10000 --method hulls --set hull.corners=rectangle --set hull.sharpness=vmf --eye 9,6,3 \
	--target 2,1,-1
same hulls 2 area-light atrium:triangles=10000 --method hulls
answered hulls
views="--set octree.levels=3 --set vpl.paths=20"
same megaviews 2 indirect atrium:triangles=10000 --method megaviews $views --set view_map.px=4
same megaviews 2 indirect atrium:triangles=10000 --method megaviews $views --set view_map.px=32 --set view_map.apart=0
same megaviews 2 indirect dining:triangles=10000 --method megaviews $views --set view_map.px=8 --set view_map.multipixel=texels \
	--set view_map.fill=0.3
answered megaviews
finish
