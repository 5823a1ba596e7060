# Shared by tools/env and its parts (sourced): messages, places, checks.
# shellcheck shell=bash disable=SC2034,SC2154

say() { printf 'superquadric: %s\n' "$*" >&2; }

die() {
  printf 'superquadric: ERROR: %s\n' "$1" >&2
  shift
  [ $# -eq 0 ] || printf '  %s\n' "$@" >&2
  exit 1
}

minimumYade=2025.2      # the oldest YADE that the plugin is written for
debianSuite=${YADE_SUITE:-trixie}   # the Debian whose YADE is used on machines that have none themselves (trixie: 13)
recipe=1                # raise when the way the Debian root is made changes

# As ordinary users see it: a relative XDG_CACHE_HOME is invalid by its specification.
case ${XDG_CACHE_HOME:-} in
  /*) cache=$XDG_CACHE_HOME/yade-superquadric ;;
  *) cache=${HOME:?}/.cache/yade-superquadric ;;
esac

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

# machine_suite: the code name of this system's release.
machine_suite() { (. /etc/os-release && echo "${VERSION_CODENAME:-}"); }

# packages_of SET...: the package names in tools/packages/SET, sorted, each once.
packages_of() {
  (cd "$project/tools/packages" && sed -e 's/#.*//' "$@") | xargs -n1 | sort -u
}

# short_hash: 12 characters that stand for what comes in.
short_hash() { sha256sum | cut -c1-12; }

# missing_packages PACKAGE...: those that are not installed on this machine.
missing_packages() {
  local package
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || echo "$package"
  done
}
