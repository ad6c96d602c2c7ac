#!/bin/bash
# The stranger's lane, on a repository of a few files that stands in for this one: what works passes, and a fault in a
# shell line whose path has a blank, a recipe that changes nothing, and a workflow whose target does not exist each
# fail. Prints TAP.
. "$(dirname "$0")/../cli/tap.bash"
lane=$(realpath scripts/stranger)
cd "$scratch" || exit
chmod a+rx . && chmod a+x .. # the stranger is another user
mkdir -p small/{reference,src/methods/points,src/kernels/points,src/scene/builtin}
cd small || exit
printf '# Small\n\n## Start\n\n    make demo\n    make test # after it\n' > README.md
cat > reference/RECIPES.md <<'PAGE'
# Recipes

## Change a kernel
This line becomes the next:

    half = 0.5;
    half = 0.25;

1. Build and look:

       make
       build/touchstone render reflections atrium --method epr -o out/mine

## Add a built-in scene
1. A file:

       a pillar
2. A row in it:

       SCENE(cell)
3. Build and look:

       make
       build/touchstone render reflections cell --method epr -o out/mine

## Add a method of existing stages
At the end:

    supersample

Build and look:

    make
    build/touchstone render reflections dining --size 480x270 --method mvr-supersample -o out/mine
PAGE
cat > reference/CI.md <<'PAGE'
# CI

### GitHub Actions

```yaml
jobs:
  build:
    steps:
      - name: build
        run: |
          apt-get update
          make deps-build && make
  shard:
    steps:
      - name: check
        run: build/touchstone golden check --shard ${{ matrix.shard }}/4
  merge:
    steps:
      - name: merge
        run: build/touchstone merge
```
PAGE
echo 'half = 0.5;' > src/kernels/points/splat_box.h
echo 'PIPELINE(mvr_reflections)' > src/methods/points/family.def
echo trilinear > src/methods/points/mvr.c
echo 'SCENE(atrium)' > src/scene/builtin/scenes.def
printf 'build\nout\nsaid\n' > .gitignore
cat > Makefile <<'MAKE'
all deps-build demo test:
	mkdir -p build && cp program build/touchstone
	@[ $@ != test ] || echo '1 passed, 0 failed, 0 skipped'
MAKE
# A picture is what was read: a kernel, the scene, and the filter of the method or of --set.
cat > program <<'PROGRAM'
#!/bin/bash
[ "$1" = compare ] && { cmp -s "$2" "$3"; exit; }
scene=$3
while [ $# -gt 0 ]; do
	case $1 in --method) method=$2 ;; -o) to=$2 ;; --set) set=${2#*=} ;; esac
	shift
done
mkdir -p "$to"
[ "$method" = mvr-supersample ] && set=$(tail -n 1 src/methods/points/mvr.c)
scene=$(cat "src/scene/builtin/$scene.c" 2> /dev/null)
{ cat src/kernels/points/splat_box.h; echo "$scene ${set:-trilinear}"; } > "$to/$method.png"
grep -q 0.5 src/kernels/points/splat_box.h ||
	echo 'left out: the fast paths of splat, as said; splat runs without its fast path'
PROGRAM
chmod +x program
git init -q . && git add -A && git -c user.name=one -c user.email=one commit -qm small
cd ..

n=0
# ends STATUS LAST NAME [PATTERN]: the lane, on what stands there.
ends() {
	git -C small -c user.name=one -c user.email=one commit -qam planted --allow-empty
	"$lane" --short "$((n += 1))" small > said 2>&1
	[ $? -eq "$1" ] && [ "$(tail -n 1 said)" = "$2" ] && grep -q -- "${4:-ok}" said
	verdict $? "$3"
	git -C small reset -q --hard "$(git -C small rev-list --max-parents=0 HEAD)"
}
if ! unshare --net true 2> said && [ "$EUID" -eq 0 ]; then
	echo '1..0 # SKIP root cannot leave the network here'
	exit
fi
ends 0 '8 passed, 0 failed, 0 skipped' 'what README, RECIPES and CI say is done'
sed -i 's|^\tmkdir.*|&\n\tcd $(CURDIR) \&\& rm -f .gitignore|' small/Makefile
ends 1 '1 passed, 6 failed, 0 skipped' 'a path that meets a shell without quotes' '^make demo  *FAILED'
sed -i 's|^\tmkdir.*|&\n\tat=$(CURDIR); rm -f .gitignore|' small/Makefile
ends 1 '7 passed, 1 failed, 0 skipped' 'a file of the tree that goes, though all passes' '^git status is clean  *FAILED'
sed -i 's/half = 0.25/half = 0.50/' small/reference/RECIPES.md
ends 1 '7 passed, 1 failed, 0 skipped' 'a recipe that changes nothing' '^RECIPES: a kernel  *FAILED'
sed -i 's/^trilinear/supersample/' small/src/methods/points/mvr.c
sed -i 's/ set=${2#\*=}/ :/' small/program
ends 1 '7 passed, 1 failed, 0 skipped' 'a method whose value does nothing' '^RECIPES: a method  *FAILED'
sed -i 's/half = 0.5;/full = 0.5;/' small/src/kernels/points/splat_box.h
ends 1 '7 passed, 1 failed, 0 skipped' 'a recipe whose line is not there' 'cannot be typed in'
sed -i 's/make deps-build/make deps/' small/reference/CI.md
ends 1 '7 passed, 1 failed, 0 skipped' 'a target that does not exist' '^CI: the workflow  *FAILED'
finish
