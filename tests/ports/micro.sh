#!/bin/bash
# The triangles and surfels of scenes/ become what reference/PORTING.md says: values that can be worked out by hand.
. "$(dirname "$0")/../cli/tap.bash"
. "$(dirname "$0")/ports.bash"

trace triangle scenes/triangle.gltf --camera camera --reflectors 0 --size 16x16
for scene in triangle_mirror triangle_twice triangle_edge triangle_side; do micro $scene $scene; done
micro triangle_behind triangle_behind --set splat.clip=off
for folder in box seen splats; do
	read -ra command <<< "$(sed -n "s/^[$] touchstone \(render .*\) -o $folder > .*/\1/p" reference/PORTING.md)"
	run "${command[@]}" -o "$scratch/$folder"
done
/usr/bin/python3 tests/ports/micro.py "$scratch"/triangle{,_mirror,_twice,_edge,_side,_behind}/trace-epr \
	"$scratch"/{box/trace-hulls,seen/trace-megaviews,splats/trace-deferred}
