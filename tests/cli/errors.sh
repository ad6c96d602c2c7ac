#!/bin/bash
# Whatever is typed wrongly ends in one line that says what would be right, and exit code 2.
. "$(dirname "$0")/tap.bash"

refuses 'touchstone help'
refuses 'the nearest is render' rendr
refuses 'render EFFECT' render
refuses 'the nearest is reflections' render reflexions
refuses 'the nearest is --method' render reflections --metod epr
refuses 'the nearest is epr' render reflections --method eprr
refuses 'no option -q' render reflections -q
refuses 'needs a value' render reflections -o
refuses 'needs a value' render reflections --size
refuses 'takes no value' render reflections --json=3
refuses 'too many' render reflections atrium another
refuses 'from 16 to 16384' render reflections --size 100000x100000
refuses 'WIDTHxHEIGHT' render reflections --size 1920
refuses 'height' render reflections --size 1920x
refuses 'the nearest is width' render reflections --set widht=640
refuses '=' render reflections --set width
refuses 'width' render reflections --set width=640x
refuses 'frame' render reflections --frame -1
refuses 'A, B and C' render reflections --truth=D
refuses 'from 1 to 1024' render reflections --threads 0
refuses 'out of range' render reflections atrium:triangles=1000000000 --no-images
refuses 'no such scene' render reflections atrum --no-images
refuses 'No such file' info /nonexistent/scene.glb
refuses 'directory' info .
refuses 'nearest is buffers' list buffer
refuses 'epr-1 and epr-2' bench epr-3
refuses 'whole number' bench epr-1 --objects 1,x
refuses 'not several' bench epr-2 --truth=A,B
refuses 'built-in' digest scene.glb
refuses 'the nearest is render' help rendr

"$touchstone" list params > /dev/full 2> "$scratch/stderr"
[ $? -eq 2 ] && grep -q 'disk may be full' "$scratch/stderr"
verdict $? 'a full standard output is an error'

finish
