# The environment on other systems: a Debian root in the user's cache folder, made once with
# mmdebstrap and entered with bubblewrap (sourced by tools/env). The machine's own packages are not touched
# beyond these two tools. Roots of several releases (YADE_SUITE) stand side by side: debian-SUITE-HASH.
# shellcheck shell=bash disable=SC2016,SC2034,SC2154

root_tools() {
  local missing tools=(mmdebstrap bubblewrap)
  [ "$(id -u)" -eq 0 ] || tools+=(uidmap)
  mapfile -t missing < <(missing_packages "${tools[@]}")
  [ "${#missing[@]}" -eq 0 ] ||
    as_root "YADE >= $minimumYade is not in this system; the tools to make a Debian $debianSuite folder are needed" \
      "apt-get update && apt-get install --yes --no-install-recommends ${missing[*]}"
  [ "$(id -u)" -eq 0 ] || grep -qs "^$(id -un):" /etc/subuid ||
    die "this account has no subordinate user ids (/etc/subuid). Please ask the administrator for:" \
      "usermod --add-subuids 100000-165535 --add-subgids 100000-165535 $(id -un)"
}

# root_with PACKAGE...: a finished root of the suite that has all of the packages, or nothing.
root_with() {
  local list
  for list in "$cache/debian-$debianSuite"-*/etc/superquadric-packages; do
    case $list in *.tmp/*) continue ;; esac
    if [ -f "$list" ] && [ -z "$(comm -23 <(printf '%s\n' "$@") "$list")" ]; then
      echo "${list%/etc/*}"
      return
    fi
  done
}

# make_root TARGET: a Debian root with the package names that come in. Complete or not there at all: it
# is made under another name and renamed. An ordinary user gets it through an archive,
# so that every file belongs to the user (and a plain rm -rf removes it).
make_root() {
  local target=$1 work=$1.tmp packages options
  packages=$(cat)
  rm -rf --one-file-system "$work" || die "cannot remove the unfinished $work"
  source_lines deb "$debianSuite" >"$cache/root.list"
  options=(--variant=minbase "--include=$(paste -sd, <<<"$packages")"
    --dpkgopt=force-unsafe-io '--dpkgopt=path-exclude=/usr/share/man/*' '--dpkgopt=path-exclude=/usr/share/locale/*'
    '--dpkgopt=path-exclude=/usr/share/doc/*' '--dpkgopt=path-include=/usr/share/doc/*/copyright'
    --customize-hook='touch "$1/etc/resolv.conf" "$1/etc/hosts"'
    --customize-hook='rm -rf "$1"/var/lib/apt/lists/* "$1"/var/cache/apt/*')
  say "making a Debian $debianSuite folder with YADE and a compiler in $target (2-4 minutes, 3 GB)"
  if [ "$(id -u)" -eq 0 ]; then
    mmdebstrap --mode=root "${options[@]}" "$debianSuite" "$work" "$cache/root.list" >&2
  else
    mkdir -p "$work" &&
      TMPDIR=/var/tmp mmdebstrap --mode=unshare --format=tar "${options[@]}" "$debianSuite" - "$cache/root.list" |
      tar -x -C "$work" --no-same-owner --exclude='./dev/*'
  fi || { rm -rf --one-file-system "$work"; die "the Debian $debianSuite folder could not be made: see the messages above." \
    "What is there stays usable; run the command again once the cause is gone."; }
  printf '%s\n' "$packages" >"$work/etc/superquadric-packages"
  mv "$work" "$target"
}

# drop_roots KEEP: remove all roots of the suite but one; those in use (their lock is held) stay until the next time.
drop_roots() {
  local old
  for old in "$cache/debian-$debianSuite"-*; do
    case $old in "$1" | *.lock | *.tmp) continue ;; esac
    [ -d "$old" ] || continue
    flock --nonblock --exclusive "$old.lock" rm -rf --one-file-system "$old" "$old.lock" ||
      say "$old is in use; it is removed another time"
  done
}

# root_ready SET...: have a root with the package sets; its list only grows, so that targets with
# different needs share one.
root_ready() {
  local wanted all
  mapfile -t wanted < <(packages_of "$@")
  root=$(root_with "${wanted[@]}")
  if [ -z "$root" ]; then
    root_tools
    suite_lists "$debianSuite"
    own_lists
    all=$({ printf '%s\n' "${wanted[@]}"; cat "$cache/debian-$debianSuite"-*/etc/superquadric-packages 2>/dev/null || true; } | sort -u)
    root=$cache/debian-$debianSuite-$(printf '%s\n' "$recipe" "$(dpkg --print-architecture)" "$all" | short_hash)
    make_root "$root" <<<"$all"
    drop_roots "$root"
  fi
  exec 8>"$root.lock"
  flock --shared 8
  environment=${root##*/}
  root_command
  yadeVersion=$(dpkg-query --admindir="$root/var/lib/dpkg" -W -f '${source:Version}' yade)
  suite=$debianSuite
}

# root_command: set `enter`, the command that runs another one in the root. The system folders are the root's (read only), everything else
# is this machine's: home, projects, /tmp with the X11 socket, network, graphics card. So paths mean
# the same inside and outside.
root_command() {
  local entry
  enter=(bwrap --proc /proc --dev /dev --dev-bind-try /dev/dri /dev/dri --ro-bind-try /sys /sys
    --dir /run --bind-try /run/user /run/user --bind-try /run/dbus /run/dbus --die-with-parent --chdir "$PWD")
  for entry in "$root"/*; do
    case ${entry##*/} in
      bin | sbin | lib* | usr | etc | var)
        if [ -L "$entry" ]; then
          enter+=(--symlink "$(readlink "$entry")" "/${entry##*/}")
        else
          enter+=(--ro-bind "$entry" "/${entry##*/}")
        fi ;;
    esac
  done
  for entry in /*; do
    case ${entry##*/} in
      bin | sbin | lib* | usr | etc | var | proc | dev | sys | run | boot | lost+found) ;;
      *)
        if [ -L "$entry" ]; then
          enter+=(--symlink "$(readlink "$entry")" "$entry")
        elif [ -d "$entry" ]; then
          enter+=(--bind "$entry" "$entry")
        fi ;;
    esac
  done
  for entry in resolv.conf hosts passwd group; do
    [ ! -e "/etc/$entry" ] || enter+=(--ro-bind "$(realpath "/etc/$entry")" "/etc/$entry")
  done
  # As root, keep root's access to files of other users (a project folder mounted into a container), and let mpirun start.
  [ "$(id -u)" -ne 0 ] ||
    enter+=(--cap-add CAP_DAC_OVERRIDE --setenv OMPI_ALLOW_RUN_AS_ROOT 1 --setenv OMPI_ALLOW_RUN_AS_ROOT_CONFIRM 1)
  # The root has no other locale, and unknown ones make Boost and Qt give up.
  enter+=(--setenv LC_ALL C.UTF-8 --unsetenv LANGUAGE --)
}
