#!/usr/bin/env bash
# Builds Debian's packages, checks them with lintian, installs them in a clean Debian 12 of their own, uses them there as an ordinary
# user, and removes them. The clean system is made once (debootstrap) and copied for each run. Says why and exits with 77 where
# that cannot be done. Usage: packages.sh BUILD FOLDER
set -euo pipefail
build=$1 folder=$2
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
skip() { printf 'skipped: %s\n' "$*"; exit 77; }
fail() { printf '%s\n' "$*" >&2; exit 1; }
[[ $(id -u) == 0 ]] || skip "chroot is root's"
for tool in debootstrap dpkg-shlibdeps file lintian cpack; do
    command -v $tool >/dev/null || skip "$tool is absent"
done

base=$folder/base root=$folder/root packages=$folder/packages
rm -rf "$root" "$packages"
mkdir -p "$folder"
# The packages are for all users, whatever the umask of who makes them.
(umask 077 && cd "$build" && cpack -B "$packages" >"$folder/cpack.log" 2>&1) || fail "cpack: $(tail -5 "$folder/cpack.log")"
rm -rf "$packages/_CPack_Packages"
for name in burl burl-doc libburl0 libburl-dev; do
    compgen -G "$packages/${name}_*.deb" >/dev/null || fail "cpack made no package $name"
done
for package in "$packages"/*.deb; do
    private=$(dpkg-deb -c "$package" | grep -Ev '^(.rw.r-.r-.|lrwxrwxrwx)') || continue
    fail "not for all users: $private"
done
lintian --allow-root --fail-on error "$packages"/*.deb || fail "lintian has errors"

if [[ ! -e $base.done ]]; then
    rm -rf "$base"
    debootstrap --variant=minbase bookworm "$base" http://deb.debian.org/debian >"$folder/debootstrap.log" 2>&1 ||
        skip "debootstrap: $(tail -1 "$folder/debootstrap.log")"
    touch "$base.done"
fi
cp -a "$base" "$root"
cp /etc/resolv.conf "$root/etc/resolv.conf"
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
as_user() { chroot --userspec=user:user "$root" env -i PATH=/usr/bin:/bin HOME=/home/user LC_ALL=C.UTF-8 "$@"; }
apt() { inside apt-get -q -o APT::Install-Recommends=false -o APT::Sandbox::User=root "$@" >"$folder/apt.log" 2>&1; }
apt update || skip "no packages of Debian: $(tail -1 "$folder/apt.log")"
inside useradd -m user
cp "$packages"/*.deb "$root/tmp"

# The program alone.
program=$(basename "$packages"/burl_*.deb)
apt install -y "./tmp/$program" || fail "apt install ./$program: $(tail -5 "$folder/apt.log")"
SECONDS=0
as_user burl bake sample:teapot --recipe oak --size 512 -o /home/user/teapot.glb --quiet
[[ $(head -c 4 "$root/home/user/teapot.glb") == glTF ]] || fail "burl bake made no glTF"
((SECONDS <= 30)) || fail "burl bake took $SECONDS s"
as_user burl --version | grep -q "^burl [0-9]" || fail "burl --version says nothing"
for file in man/man1/burl.1.gz man/man1/burl-bake.1.gz bash-completion/completions/burl mime/packages/burl.xml \
    applications/burl-edit.desktop burl/burl_addon.py burl/burl-array.sh; do
    # A small Debian leaves manual pages out.
    [[ -e $root/usr/share/$file ]] || dpkg-deb -c "$packages/$program" | grep -q "/$file\$" || fail "there is no $file"
done

# ./demo uses the package. (Its pictures need a package that is only recommended.)
mkdir -p "$root/home/user/checkout/.ci"
cp demo packages.txt "$root/home/user/checkout"
cp .ci/packages.sh "$root/home/user/checkout/.ci"
inside chown -R user:user /home/user/checkout
said=$(as_user bash /home/user/checkout/demo 2>&1 || true)
[[ $said == *"Using the installed package: /usr/bin/burl (burl "* ]] || fail "./demo does not use the package: $said"
[[ $(head -c 4 "$root/home/user/checkout/out/teapot-oak.glb") == glTF ]] || fail "./demo made no glTF: $said"

# The library, for C++ and for Python.
apt install -y $(cd "$packages" && ls | grep -v "^burl_" | sed 's|^|./tmp/|') || fail "apt install: $(tail -5 "$folder/apt.log")"
inside ldconfig -p | grep -q "libburl\.so\.0 " || fail "ldconfig does not know libburl.so.0"
libdir=$root/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)
[[ -e $libdir/libburl.so.0 ]] || fail "libburl0 is not in $libdir"
[[ -e $root/usr/include/burl/bake.h && -e $libdir/cmake/burl/burlConfig.cmake ]] || fail "libburl-dev lacks its files"
if compgen -G "$packages/python3-burl_*.deb" >/dev/null; then
    as_user python3 -c "
import burl
burl.bake('sample:teapot', 'oak', size=512).write('/home/user/python.glb')
" || fail "the Python package does not bake"
    cmp "$root/home/user/teapot.glb" "$root/home/user/python.glb"
fi
files_of_burl() { find "$root" -xdev \( -iname '*burl*' -o -path '*burl*' \) -not -path "$root/tmp/*" -not -path "$root/home/*" | sed "s|^$root||" | sort; }
[[ $(files_of_burl | wc -l) -gt 30 ]] || fail "the packages have hardly a file"

apt purge -y burl burl-doc libburl0 libburl-dev || fail "apt purge: $(tail -5 "$folder/apt.log")"
left=$(files_of_burl)
[[ -z $left ]] || fail "left behind: $left"
rm -rf "$root"
printf 'packages: '
(cd "$packages" && du -h --apparent-size -- *.deb | awk '{printf "%s %s, ", $2, $1}')
printf '\n'
