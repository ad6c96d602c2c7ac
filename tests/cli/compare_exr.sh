#!/bin/bash
# `compare` of OpenEXR files: whole numbers are not rounded to floats, and the place in the whole picture counts.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/images.bash"
cd "$scratch" || exit 2
for n in 16777216 16777217; do writes_exr "$n.exr" I 0 0 "$n"; done
run compare 16777216.exr 16777217.exr
[ "$status" -eq 1 ] && grep -q 'ref 16777216 candidate 16777217' stdout
verdict $? 'whole numbers one apart'
run compare 16777217.exr 16777217.exr
[ "$status" -eq 0 ] && grep -q '0 different' stdout
verdict $? 'whole numbers that are equal'
run compare 16777216.exr 16777217.exr --abs 1
[ "$status" -eq 0 ]
verdict $? 'a tolerance of whole numbers'
writes_exr floats.exr Y
refuses 'other channels of whole numbers than those of the reference' compare floats.exr 16777216.exr
writes_exr at_0.exr RGB 0 32
writes_exr at_5.exr RGB 5 32
writes_exr of_64.exr RGB 0 64
refuses 'at_5.exr: begins at pixel 5,5 of the picture; the reference at 0,0$' compare at_0.exr at_5.exr
refuses 'of_64.exr: part of a picture of 0,0,64,64; the reference of 0,0,32,32$' compare at_0.exr of_64.exr
run compare at_5.exr at_5.exr
[ "$status" -eq 0 ]
verdict $? 'the same place'
finish
