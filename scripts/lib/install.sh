# shellcheck shell=bash
# Sourced by scripts/run and scripts/test: installs what is missing with apt, and no more.

say() { printf '== %s\n' "$*"; }

fail() {
  printf 'error: %s\n' "$*" >&2
  exit 1
}

# head_of_script: what the comment at the head of the running script says. From the project's root.
head_of_script() { sed -n '2,/^set/ { /^#/ s/^# \{0,1\}//p; }' "scripts/${0##*/}"; }

# answer_help "$@": for scripts whose only option is --help.
answer_help() {
  if [ "${1-}" = --help ] || [ "${1-}" = -h ]; then
    head_of_script
    exit
  fi
}

is_root() { [ "$(id -u)" -eq 0 ]; }

as_root() { if is_root; then "$@"; else sudo "$@"; fi; }

# needs_package PACKAGE[/COMMAND]: a tool counts as present when its command is, wherever it came from.
needs_package() {
  local package=${1%%/*} command=${1#*/}
  if [ "$command" != "$1" ]; then
    ! command -v "$command" > /dev/null
  else
    ! dpkg-query -W -f '${db:Status-Status}\n' "$package" 2> /dev/null | grep -qx installed
  fi
}

# knows_package PACKAGE: the lists of apt are there and contain it.
knows_package() { apt-cache show --no-all-versions "$1" > /dev/null 2>&1; }

update_lists() {
  say "apt-get update: the package lists are missing or too old"
  as_root apt-get update -q || fail "apt-get update failed"
}

# fail_without_root COMMAND…: who may not install is told what to have installed.
fail_without_root() {
  if is_root || command -v sudo > /dev/null; then return; fi
  printf 'error: this needs root, and there is no sudo. As root, run\n  %s\nand try again.\n' "$*" >&2
  exit 1
}

# install_missing PACKAGE[/COMMAND]…
install_missing() {
  local item package missing=()
  for item; do
    if needs_package "$item"; then missing+=("${item%%/*}"); fi
  done
  if [ ${#missing[@]} -eq 0 ]; then return; fi

  local install=(apt-get install -y --no-remove --no-install-recommends "${missing[@]}")
  fail_without_root "${install[*]}"
  for package in "${missing[@]}"; do
    if ! knows_package "$package"; then
      update_lists
      break
    fi
  done
  say "installing with apt: ${missing[*]}"
  run_install "${install[@]}" && return
  update_lists # the lists named files that are gone from the archive
  run_install "${install[@]}" || fail "could not install: ${missing[*]}. The line was: ${install[*]}"
}

run_install() { as_root env DEBIAN_FRONTEND=noninteractive "$@" -q -o DPkg::Lock::Timeout=300; }

# Compilations at a time: one for each core, and 3 GB of memory for each.
number_of_jobs() {
  local cores gigabytes
  cores=$(nproc)
  gigabytes=$(awk '/^MemAvailable:/ { print int($2 / 3000000) }' /proc/meminfo)
  if [ "$gigabytes" -lt 1 ]; then gigabytes=1; fi
  echo $((cores < gigabytes ? cores : gigabytes))
}
