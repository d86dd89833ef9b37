# shellcheck shell=bash disable=SC2154 # $root comes from the caller
# Shell functions that demo and check share: which packages of packages.txt are missing, and installing
# them. Source it with $root set to the checkout's folder.

say() { printf '%s\n' "$*"; }
fail() { printf '%s\n' "$*" >&2; exit 1; }

# The list's lines of the given kinds, comments and blank lines left out.
listed() { # KIND...
    local kinds=" $* " name kind option
    sed 's/#.*//' "$root/packages.txt" | while read -r name kind option; do
        if [[ -n $name && $kinds == *" $kind "* ]]; then say "$name $option"; fi
    done
}

installed() { # PACKAGE
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]
}

# Prints the missing packages of the given kinds, those marked optional or command=NAME only with
# `optional` as first word and the others only without.
missing() { # [optional] KIND...
    local optional=
    if [[ $1 == optional ]]; then optional=yes; shift; fi
    local name option
    listed "$@" | while read -r name option; do
        if [[ $option == command=* ]]; then
            if [[ -n $optional ]] && ! command -v "${option#command=}" >/dev/null; then say "$name"; fi
        elif [[ $option == optional ]]; then
            if [[ -n $optional ]] && ! installed "$name"; then say "$name"; fi
        elif [[ -z $optional ]] && ! installed "$name"; then
            say "$name"
        fi
    done
}

as_root() {
    if [[ $(id -u) == 0 ]]; then "$@"; else sudo "$@"; fi
}

apt_install() { # PACKAGE...
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 -q install -y \
        --no-install-recommends "$@"
}

# apt-get update once per run; a source of somebody else's that fails must not stop us.
updated=
apt_update() {
    if [[ -z $updated ]]; then
        updated=yes
        as_root apt-get -o DPkg::Lock::Timeout=300 -q update ||
            say "apt-get update had trouble; going on with the package lists at hand."
    fi
}

can_install() {
    command -v apt-get >/dev/null && { [[ $(id -u) == 0 ]] || command -v sudo >/dev/null; }
}

# Installs what is missing of the given kinds; does not call apt at all when nothing is.
install_packages() { # KIND...
    local needed
    command -v dpkg-query >/dev/null ||
        fail "This is no Debian system (dpkg-query is missing): install what packages.txt lists by hand and build with cmake --preset release."
    needed=$(missing "$@" | tr '\n' ' ')
    if [[ -n $needed ]]; then
        can_install ||
            fail "These packages are missing: $needed- run this as root or install sudo, or have them installed by: apt-get install $needed"
        say "Installing: $needed"
        apt_update
        # shellcheck disable=SC2086 # a list of words
        apt_install $needed ||
            fail "apt-get could not install: $needed- see its message above; packages.txt is written for Debian 12."
    fi
}

# The same for the optional ones, whose absence is said and then lived with.
install_optional_packages() { # KIND...
    local needed
    needed=$(missing optional "$@" | tr '\n' ' ')
    if [[ -n $needed ]]; then
        say "Installing, if possible: $needed"
        # shellcheck disable=SC2086
        if ! { can_install && apt_update && apt_install $needed; }; then
            say "Going on without: $needed(what needs them is skipped)"
        fi
    fi
}

# Compiles with ccache where there is one, so that a second checkout builds quickly.
use_ccache() {
    if command -v ccache >/dev/null; then
        export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_NOHASHDIR=1 CCACHE_BASEDIR="$root" CCACHE_DEPEND=1
    fi
}

configure_and_build() { # PRESET CONFIGURE_OPTIONS... -- BUILD_OPTIONS...
    local preset=$1 options=()
    shift
    while [[ $# -gt 0 && $1 != -- ]]; do options+=("$1"); shift; done
    shift || true
    (cd "$root" && cmake --preset "$preset" "${options[@]}" && cmake --build --preset "$preset" "$@")
}
