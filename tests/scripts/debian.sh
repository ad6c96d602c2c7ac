#!/bin/bash
# The packaging in debian/ says what the tree says: version, soname, what is needed to build; who gets which file
# install.sh asks. Lintian reads the source package where it is installed; `make distros` builds and installs the
# packages.
. "$(dirname "$0")/../cli/tap.bash"
library=${BUILD:-build/release}/libtouchstone.so

version=$("$touchstone" --version | sed 's/^touchstone \([0-9.]*\),.*/\1/')
[ -n "$version" ] && [ "$(sed -n '1s/^touchstone (\(.*\)) .*/\1/p' debian/changelog)" = "$version" ]
verdict $? 'the version of the changelog is that of the command'
soname=$(readelf -d "$library" | sed -n 's/.*SONAME.*\[libtouchstone\.so\.\(.*\)\]/\1/p')
grep -qx "Package: libtouchstone$soname" debian/control && [ -e "debian/libtouchstone$soname.install" ] &&
	[ "$(grep -oh 'libtouchstone[0-9.]*[0-9]' debian/control | sort -u)" = "libtouchstone$soname" ]
verdict $? 'the library is in the package of its soname'

# What is missing on a machine without any package; compilers,
# make and libc every Debian machine that builds packages has.
mkdir "$scratch/bin"
printf '#!/bin/bash\nexit 1\n' | tee "$scratch/bin/dpkg-query" > "$scratch/bin/apt-get"
chmod +x "$scratch/bin"/*
(PATH=$scratch/bin:$PATH TS_INSTALL=0 scripts/install-deps 2>&1 | sed 's/.* missing: //' | tr ' ' '\n' |
	grep -vxE 'gcc|g\+\+|make|libc6-dev' && echo clang && echo 'debhelper-compat (= 13)') | sort > "$scratch/wanted"
sed -n '/^Build-Depends:/,/^[^ ]/s/^ \(.*\),$/\1/p' debian/control | sort | diff "$scratch/wanted" - | sed 's/^/# /'
verdict "${PIPESTATUS[2]}" 'to build it what install-deps --build installs is needed, and clang'

# variables: those that standard input sets.
variables() {
	grep -oE '\b[A-Z_]+=' | sort -u
}
unset_ones=$(comm -23 <(sed -n '/^installcheck:/,/scripts\/installcheck$/p' scripts/make/install.mk | variables) \
	<(variables < debian/tests/library))
[ -z "$unset_ones" ]
verdict $? 'its test of the library sets all that scripts/installcheck reads'
[ -z "$unset_ones" ] || echo "# not set:" $unset_ones

if [ -e .git ] && [ "$(command -v dpkg-source lintian dh | wc -l)" -eq 3 ]; then
	tar -xJf "$(make -s dist | tail -n 1)" -C "$scratch" &&
		(cd "$scratch" && dpkg-source -b touchstone-[0-9]* && lintian --fail-on error,warning ./*.dsc) \
		> "$scratch/stdout" 2>&1
	verdict $? 'lintian accepts the source package'
	grep '^[EW]:' "$scratch/stdout" | sed 's/^/# /'
else
	echo "ok $((tests += 1)) - lintian # SKIP no git, dpkg-source, debhelper or lintian here"
fi
finish
