# What ./run and ./test do first: install what Knotspan needs and this machine lacks, then build.
#
# Sourced, with `root` set to the project's folder. All it says goes to standard error; where nothing is missing
# it says nothing, asks dpkg alone and so needs no network. The packages' purposes: docs/architecture.md.

packages_to_build=(
    g++ cmake ninja-build pkg-config ccache
    qt6-base-dev libvulkan-dev glslc libglm-dev
    libocct-foundation-dev libocct-modeling-algorithms-dev libocct-data-exchange-dev libtbb-dev libhwy-dev libfontconfig-dev
    libvtk9-dev
    nlohmann-json3-dev libcli11-dev libexpected-dev
)
packages_to_run=(qt6-qpa-plugins qt6-wayland mesa-vulkan-drivers)
packages_to_test=(libgtest-dev libbenchmark-dev libboost-dev libopenmesh-dev vulkan-validationlayers spirv-tools xvfb xauth
    desktop-file-utils appstream shared-mime-info dpkg-dev file)

# Models of other people's, for ./test --corpus: 6 GB once installed.
packages_of_corpora=(gmsh-doc calculix-cgx-examples freecad-common kicad-demos kicad-packages3d gzip unzip)

say() { printf '%s\n' "$*" >&2; }

system_name() { ( . /etc/os-release 2>/dev/null; printf '%s %s' "${ID:-unknown}" "${VERSION_ID:-}" ); }

# Prints those of the packages that are not installed.
missing_of() {
    local installed
    installed=" $(dpkg-query -W -f='${Package}=${db:Status-Status} ' "$@" 2>/dev/null || true)"
    local package
    for package in "$@"; do
        [[ $installed == *" $package=installed "* ]] || printf '%s ' "$package"
    done
}

as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi; }

may_be_root() {
    [ "$(id -u)" = 0 ] || { command -v sudo >/dev/null && { sudo -n true 2>/dev/null || sudo true; }; }
}

# Runs apt-get with its many lines kept in a file; shows their end where it fails.
apt_get() {
    mkdir -p "$root/build"
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 "$@" \
        </dev/null >"$root/build/apt.log" 2>&1 || { tail -n 12 "$root/build/apt.log" >&2; return 1; }
}

# Debian 12's own Mesa (22.3) has no task and mesh stages in software; that of its backports has. It is taken from
# there only where no driver at hand offers them: not beside another maker's driver, and not where a tool says so.
needs_newer_mesa() {
    [ "$(system_name)" = "debian 12" ] || return 1
    local version mesas_own driver
    version=$(dpkg-query -W -f='${Version}' mesa-vulkan-drivers 2>/dev/null || true)
    [ -z "$version" ] || dpkg --compare-versions "$version" lt 24 || return 1
    mesas_own=$(dpkg-query -L mesa-vulkan-drivers 2>/dev/null || true)
    for driver in /usr/share/vulkan/icd.d/*.json /etc/vulkan/icd.d/*.json; do
        [ ! -e "$driver" ] || grep -qxF "$driver" <<<"$mesas_own" || return 1
    done
    ! { command -v vulkaninfo >/dev/null && vulkaninfo 2>/dev/null | grep VK_EXT_mesh_shader >/dev/null; }
}

has_backports() { apt-cache policy | grep 'n=bookworm-backports' >/dev/null; }

# Makes bookworm-backports known to apt, from the place that this machine takes Debian from.
add_backports() {
    if has_backports; then
        apt_get update || true
        return 0
    fi
    local list=/etc/apt/sources.list.d/knotspan-backports.sources key=/usr/share/keyrings/debian-archive-keyring.gpg uri
    uri=$(apt-get indextargets --format '$(REPO_URI)' \
        'Identifier: Packages' 'Codename: bookworm' 'Origin: Debian' | awk 'NR == 1')
    [ -n "$uri" ] || { say "None of apt's sources is Debian 12 itself."; return 1; }
    say "Adding $list: Debian's own backports, from where this machine takes Debian."
    { printf 'Types: deb\nURIs: %s\nSuites: bookworm-backports\nComponents: main\n' "$uri"
      [ ! -e "$key" ] || printf 'Signed-By: %s\n' "$key"; } | as_root tee "$list" >/dev/null
    apt_get update && has_backports && return 0
    as_root rm -f "$list"
    return 1
}

install_newer_mesa() {
    local given_up="$root/build/without-newer-mesa"
    [ ! -e "$given_up" ] || return 0
    say "Installing mesa-vulkan-drivers from bookworm-backports: Debian 12's own has no mesh shaders in software."
    may_be_root && add_backports &&
        apt_get install --no-install-recommends -t bookworm-backports mesa-vulkan-drivers && return 0
    mkdir -p "$root/build" && : >"$given_up"
    say "That did not work: the mesh paths will be greyed out, the tessellation path works."
    say "To try again, as an administrator or with a network, remove $given_up first."
}

# set_up PACKAGE…: installs those that are missing, or says what an administrator is to type and fails.
set_up() {
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        [ -d "$root/build" ] || say "No Debian or Ubuntu, so nothing is installed here. Needed is what these hold: $*"
        return 0
    fi
    case "$(system_name)" in
        "debian 12" | "debian 13" | "ubuntu 24.04") ;;
        *) [ -d "$root/build" ] ||
            say "Made for Debian 12, Debian 13 and Ubuntu 24.04; on $(system_name) packages may be named otherwise." ;;
    esac
    local newer_mesa=0 missing
    ! needs_newer_mesa || newer_mesa=1
    read -ra missing <<<"$(missing_of "$@")"
    if [ ${#missing[@]} -gt 0 ]; then
        if ! may_be_root; then
            say "Knotspan needs packages that are not installed, and this user may not install them."
            say "Ask an administrator to run:"
            say "  apt-get install --no-install-recommends ${missing[*]}"
            return 1
        fi
        say "Installing what building Knotspan needs and this machine lacks (a few minutes): ${missing[*]}"
        # A package list that cannot be renewed may still do; the installation tells.
        apt_get update || say "apt-get update failed; trying with the package lists that are there."
    fi
    [ $newer_mesa = 0 ] || install_newer_mesa
    read -ra missing <<<"$(missing_of "$@")"
    [ ${#missing[@]} = 0 ] || apt_get install --no-install-recommends "${missing[@]}" || {
        say "Installing failed: see above and $root/build/apt.log. Still missing: $(missing_of "$@")"
        say "(Ubuntu has some of them in its component 'universe'.)"
        return 1
    }
}

# build PRESET TARGET…: configures where the presets are newer, then builds what changed.
build() (
    cd "$root" || exit
    preset=$1
    shift
    [ "build/$preset/build.ninja" -nt CMakePresets.json ] || cmake --preset "$preset" >&2
    cmake --build "build/$preset" --target "$@" >&2
)
