#!/bin/bash
# Whatever is typed wrongly ends in one line that says what would be right, and exit code 2.
. "$(dirname "$0")/tap.bash"

refuses 'touchstone help'
refuses 'the nearest is render' rendr
refuses 'no command "version"; "touchstone help" lists all$' version
refuses 'render EFFECT' render
refuses 'the nearest is reflections' render reflexions
refuses 'the nearest is --method' render reflections --metod epr
refuses 'the nearest is epr' render reflections --method eprr
refuses 'no option -x' render reflections -x
refuses 'needs a value' render reflections -o
refuses 'needs a value' render reflections --size
refuses 'takes no value' render reflections --json=3
refuses 'too many' render reflections atrium another
refuses 'not one of 1|4' render reflections --set eye.samples=3
run render surfels atrium:triangles=10000 --from-mesh 3000 --size 16x16 --set eye.samples=4 -o "$scratch/none"
[ "$status" -eq 2 ] && grep -q '^touchstone: eye.samples=4: surfels have a filter' "$scratch/stderr"
verdict $? 'four samples a pixel are refused for surfels'
refuses 'from 16 to 16384' render reflections --size 100000x100000
refuses 'WIDTHxHEIGHT' render reflections --size 1920
refuses '--size 1920x: .*WIDTHxHEIGHT' render reflections --size 1920x
refuses '--size x: .*WIDTHxHEIGHT' render reflections --size=x
refuses '--size 1x2x3' render reflections --size=1x2x3
refuses 'no option -\\x20' render reflections '- '
refuses 'no option -\\x1f' render reflections $'-\x1f'
refuses 'no option -\\xc3' render reflections '-é'
refuses 'no option -\\x01' render reflections $'-\x01'
refuses 'write --truth=A,' render reflections --truth A
refuses 'write --truth=A,B' render reflections atrium --truth A,B
refuses 'write --truth=C' bench epr-2 --truth C
refuses 'the nearest is width' render reflections --set widht=640
refuses 'no such parameter; "touchstone list params" lists all$' render reflections --set rho=1
refuses 'the nearest is lookup.bounces' render reflections --set bouncs=2
refuses 'the nearest is lookup.bounces' render reflections --set lokup.bounces=2
refuses '=' render reflections --set width
refuses 'width' render reflections --set width=640x
refuses 'frame' render reflections --frame -1
refuses 'A, B and C' render reflections --truth=D
refuses 'no backend "metal"; there is: c, opencl, vulkan, cuda$' render reflections --backend metal
refuses 'no backend ""' render reflections --backend=
refuses 'from 1 to 1024' render reflections --threads 0
refuses 'out of range' render reflections atrium:triangles=1000000000 --no-images
refuses 'no such scene' render reflections atrum --no-images
refuses 'No such file' info /nonexistent/scene.glb
refuses 'directory' info .
refuses 'nearest is buffers' list buffer
refuses 'the nearest is epr-' bench epr-4
refuses 'takes no --objects' bench ivir-1 --objects 1
refuses 'takes no --size' bench ssagh-1 --size 96x54
refuses 'takes no --size' bench nv40 --size 96x54
refuses 'not a size' bench ssagh-1 --objects 96x54,192
refuses 'takes no --output' bench start -o out
refuses 'takes no --method' bench epr-1 --method epr
refuses 'takes no --truth' bench backends --truth=C
refuses 'bench epr-1: truth.rays=5: tables judge by whole truths' bench epr-1 --set truth.rays=5
refuses 'takes one scene' bench backends --scene atrium,gallery
refuses 'whole number' bench backends --objects 1,2
refuses 'takes one method' bench start --method epr,mvr
refuses 'whole number' bench epr-1 --objects 1,x
refuses 'no such scene' bench epr-1 --scene atrium,atrum
refuses 'No such file' bench epr-2 --scene atrium,/nonexistent/scene.glb
refuses 'not several' bench epr-2 --truth=A,B
refuses 'built-in' digest scene.glb
TS_LANES=5 refuses 'TS_LANES=5: 4, 8 or 16 would be right' digest
refuses 'the nearest is render' help rendr

for command in 'list params' 'list params --json' 'help' 'info atrium:triangles=10000 --json'; do
	"$touchstone" $command > /dev/full 2> "$scratch/stderr"
	[ $? -eq 2 ] && [ "$(wc -l < "$scratch/stderr")" -eq 1 ] && grep -q 'No space left' "$scratch/stderr"
	verdict $? "a full standard output is an error: $command"
done

finish
