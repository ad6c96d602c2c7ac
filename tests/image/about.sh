#!/bin/bash
# A picture's file says what the picture shows, and nothing of when or how it was made.
. "$(dirname "$0")/../cli/tap.bash"
small=(reflections dining:triangles=10000:texels=32 --size 64x36 --reflectors 2 --frame 3 --truth=a --method epr)
says() { /usr/bin/python3 tests/image/about.py "$1" | sed "s,^[^ ]* ,," |
	grep -E '^(Software|touchstone:|capDate|tIME)' | sort; }

# expected SHOWS [LINE]: what a picture of that render says; LINE is said beside it.
expected() {
	printf '%s\n' "Software=touchstone $("$touchstone" --version | cut -d' ' -f2 | tr -d ,)" ${2+"$2"} \
		touchstone:effect=reflections touchstone:scene=dining:triangles=10000:texels=32 "touchstone:shows=$1" \
		'touchstone:params=width=64 height=36 frame=3 reflectors.count=2' | sort
}

run render "${small[@]}" -o "$scratch/one" --threads 1
verdict "$status" 'a render'
for shows in epr truth-a difference-epr-truth-a epr-points; do
	diff <(expected $shows) <(says "$scratch/one/$shows.png") > "$scratch/lines"
	verdict $? "$shows.png says what it shows"
done
for shows in epr truth-a; do
	diff <(expected $shows 'capDate=1970:01:01 00:00:00') <(says "$scratch/one/$shows.exr") > "$scratch/lines"
	verdict $? "$shows.exr says what it shows"
done

sleep 1.1
run render "${small[@]}" -o "$scratch/two" --threads 2
verdict "$status" 'the same render, later and with two threads'
same=0
for file in "$scratch"/one/*.{png,exr}; do cmp "$file" "$scratch/two/${file##*/}" || same=1; done
verdict $same 'has the same files'

run render "${small[@]}" --trace --viewer --no-images -o "$scratch/viewer"
for file in image.srgb.png=image image.radiance.exr=image eye.depth.exr=eye.depth eye.triangle.exr=eye.triangle; do
	says "$(find "$scratch/viewer" -name "${file%=*}")" | grep -qx "touchstone:shows=epr-${file#*=}"
	verdict $? "a viewer's ${file%=*} says what it shows"
done
finish
