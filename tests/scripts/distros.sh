#!/bin/bash
# What scripts/distros says of distributions, and what is left of it; nothing is installed, for debootstrap, chroot and
# autopkgtest are ours.
. "$(dirname "$0")/../cli/tap.bash"
if [ "$(id -u)" -ne 0 ] || ! unshare --mount --pid --fork true 2> /dev/null; then
	echo '1..0 # SKIP no mounts of its own are allowed here'
	exit
fi
mkdir -p "$scratch/bin" "$scratch/tree/scripts"
cp scripts/distros "$scratch/tree/scripts"
git init -q "$scratch/tree"
PATH=$scratch/bin:$PATH
command() { printf '#!/bin/bash\n%s\n' "$2" > "$scratch/bin/$1" && chmod +x "$scratch/bin/$1"; }

# judged COMMAND OF THE CHROOT: what distros says where this answers "$root" "$asked";
# each render has the files of a run.
judged() {
	command chroot "root=\$1 asked=\$* out=\$1/touchstone/\${!#}
		case \$asked in
		*' render '*)
			mkdir -p \"\$out\" && cd \"\$out\" && echo same > depth.npy && echo \$RANDOM | tee a.png > times.json
			printf '  \"compiler\": %s,\n  \"frame\": 0\n' \$RANDOM > trace.json ;;
		*apt-cache*) echo 'clang-99 - C' ;;
		esac
		$1"
	"$scratch/tree/scripts/distros" "${@:2}" > "$scratch/stdout" 2> "$scratch/stderr"
	status=$?
}
# says STATUS LAST LINE PATTERN...: of the run before.
says() {
	local pattern good=0
	[ "$status" -eq "$1" ] && [ "$(tail -n 1 "$scratch/stdout")" = "$2" ] || good=1
	for pattern in "${@:3}"; do grep -qE "$pattern" "$scratch/stdout" || good=1; done
	return $good
}

command autopkgtest '[ -e "${!#}/etc/made" ]'
command debootstrap 'mkdir -p "$3/etc" "$3/proc"'
judged true
says 0 '20 passed, 0 failed, 0 skipped' '^trixie .*traces.* ok ' '^bookworm .*goldens with clang-99 .* ok '
verdict $? 'two equal distributions pass'
judged true --short
says 0 '2 passed, 0 failed, 0 skipped' '^trixie .*goldens .* ok ' && ! grep -q bookworm "$scratch/stdout"
verdict $? 'the short one takes one'
judged '[[ $asked != *trixie*render*splats* ]] || echo other > depth.npy'
says 1 '19 passed, 1 failed, 0 skipped' '^trixie .*traces.*FAILED' '^    > [0-9a-f]{64}  \./8/depth\.npy$'
verdict $? 'another bit of a trace fails'
judged '[[ $asked != *bookworm*WERROR=1 ]] || { echo why && exit 2; }'
says 1 '16 passed, 2 failed, 0 skipped' '^bookworm  make .*FAILED' '^    why$' '^trixie .*traces.*FAILED'
verdict $? 'what does not build fails, and nothing is the same as nothing'

tar -cJf "$scratch/one.tar.xz" -C "$scratch" tree
judged '[[ $asked != *dpkg-buildpackage* ]] || touch "$1/touchstone/package/one.deb"' --packages "$scratch/one.tar.xz" \
	"$scratch/to"
says 0 '6 passed, 0 failed, 0 skipped' && [ "$(cd "$scratch/to" && echo */*)" = 'bookworm/one.deb trixie/one.deb' ] &&
	[ -x "$scratch/tree/build/distros/trixie/touchstone/package/tree/scripts/distros" ]
verdict $? 'packages of a tarball, in a folder for each'

command id 'echo 1000'
judged true
says 0 '0 passed, 0 failed, 1 skipped' 'skipped: a chroot needs root'
verdict $? 'skipped without root'
judged true --packages "$scratch/one.tar.xz" "$scratch/to"
says 1 '0 passed, 0 failed, 1 skipped' 'skipped: a chroot needs root'
verdict $? 'packages that are skipped are missing'
rm "$scratch/bin/id"
command unshare 'exit 1'
judged true
says 0 '0 passed, 0 failed, 1 skipped' 'skipped: no mounts'
verdict $? 'skipped where nothing can be mounted'
rm "$scratch/bin/unshare"
rm -r "$scratch/tree/build"
command debootstrap 'echo "E: no network" && exit 1'
judged true
says 0 '0 passed, 0 failed, 2 skipped' 'skipped: bookworm: no chroot: E: no network'
verdict $? 'skipped where no chroot can be made'
judged true --long
[ "$status" -eq 2 ] && grep -q '^distros: usage: ' "$scratch/stderr"
verdict $? 'no other word is taken'

# within: folders of /proc of what runs in the chroot.
within() {
	grep -lzx "$scratch/[l]ong" /proc/[0-9]*/cmdline 2> /dev/null | sed 's|/cmdline$||'
}
command debootstrap 'mkdir -p "$3/etc" "$3/proc"'
printf '#!/bin/bash\nsleep 1000\n' > "$scratch/long" && chmod +x "$scratch/long"
command chroot "exec '$scratch/long'"
for signal in TERM KILL; do
	"$scratch/tree/scripts/distros" --short > "$scratch/stdout" 2>&1 &
	script=$!
	for ((i = 0; i < 100; i++)); do [ -n "$(within)" ] && break || sleep 0.1; done
	grep -q trixie/proc "$(within)/mounts" && ! grep -q "$scratch" /proc/mounts
	verdict $? 'a mounted /proc is seen within alone'
	kill -$signal $script
	wait $script 2> /dev/null
	for ((i = 0; i < 50; i++)); do [ -z "$(within)" ] && break || sleep 0.1; done
	[ -z "$(within)" ] && ! grep -q "$scratch" /proc/mounts
	verdict $? "nothing is left after SIG$signal"
done
finish
