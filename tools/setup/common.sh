# Shared by tools/env and its parts (sourced): messages, places, locks, checks.
# shellcheck shell=bash disable=SC2034,SC2154

say() { printf 'superquadric: %s\n' "$*" >&2; }

die() {
  printf 'superquadric: ERROR: %s\n' "$1" >&2
  shift
  [ $# -eq 0 ] || printf '  %s\n' "$@" >&2
  exit 1
}

minimumYade=2025.2      # the oldest YADE that the plugin is written for
debianSuite=trixie      # the Debian that has it (13), for machines that do not
recipe=1                # raise when the way a Debian folder is made changes

# As ordinary users see it: a relative XDG_CACHE_HOME is invalid by its specification.
case ${XDG_CACHE_HOME:-} in
  /*) cache=$XDG_CACHE_HOME/yade-superquadric ;;
  *) cache=${HOME:?}/.cache/yade-superquadric ;;
esac

# machine_suite: the code name of this system's release.
machine_suite() { (. /etc/os-release && echo "${VERSION_CODENAME:-}"); }

# distributions: this machine's own one and those that it derives from, by their names in /etc/os-release.
distributions() { (. /etc/os-release && echo "$ID ${ID_LIKE:-}"); }

# lock FILE: one command at a time past this point, until `unlock`. There is a file for each thing that is made (a Debian folder and the headers
# of its YADE, a build directory), so that only who needs the same thing waits.
lock() {
  mkdir -p "$(dirname "$1")"
  exec 9>"$1"
  flock --nonblock 9 || { say "waiting for another command that makes the same (${1#"$cache/"})"; flock 9; }
}
unlock() { exec 9>&-; }

# as_root REASON COMMAND: run a shell command that needs the administrator's rights, or say what to ask for.
as_root() {
  say "$1"
  if [ "$(id -u)" -eq 0 ]; then
    sh -c "$2" >&2 || die "this command failed:" "$2"
  elif command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
    say "through sudo: $2"
    sudo sh -c "$2" >&2 || die "this needs the administrator. Please ask for:" "$2"
  else
    die "this needs the administrator. Please ask for:" "$2"
  fi
}

# packages_of SET...: the package names in tools/packages/SET, sorted, each once.
packages_of() {
  (cd "$project/tools/packages" && sed -e 's/#.*//' "$@") | xargs -n1 | LC_ALL=C sort -u
}

# short_hash: 12 characters that stand for what comes in.
short_hash() { sha256sum | cut -c1-12; }

# missing_packages PACKAGE...: those that are not installed on this machine.
missing_packages() {
  LC_ALL=C comm -23 <(printf '%s\n' "$@" | LC_ALL=C sort -u) \
    <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null | sed -n 's/^installed //p' | LC_ALL=C sort -u)
}

# install_packages REASON PACKAGE...: those of this system's own packages that are missing.
install_packages() {
  local reason=$1 missing
  shift
  mapfile -t missing < <(missing_packages "$@")
  [ "${#missing[@]}" -gt 0 ] || return 0
  lock "$cache/machine.lock"
  as_root "$reason: ${missing[*]}" \
    "apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends ${missing[*]}"
  unlock
}
