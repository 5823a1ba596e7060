# A Debian folder: the system folders of a Debian in the user's cache, made once with mmdebstrap and entered with bubblewrap (sourced by tools/env).
# Each suite has one of its own. The machine's own packages are not touched beyond the tools that make it.
# shellcheck shell=bash disable=SC2016,SC2034,SC2154

family=debian # folders of one family and suite share one list of packages

folder_tools() {
  local tools=(mmdebstrap bubblewrap)
  [ "$(id -u)" -eq 0 ] || tools+=(uidmap)
  [ -n "${YADE_APT_SOURCES:-}" ] || tools+=(debian-archive-keyring)
  install_packages "the tools that make a Debian folder are needed" "${tools[@]}"
  [ "$(id -u)" -eq 0 ] || grep -qs "^$(id -un):" /etc/subuid ||
    die "this account has no subordinate user ids (/etc/subuid). Please ask the administrator for:" \
      "usermod --add-subuids 100000-165535 --add-subgids 100000-165535 $(id -un)"
  bwrap --ro-bind / / --proc /proc --dev /dev true ||
    die "bubblewrap may not make namespaces here, see its message above (Ubuntu 24.04 keeps them from ordinary users)." \
      "There, please ask the administrator for: sysctl kernel.apparmor_restrict_unprivileged_userns=0"
}

# folder_with SUITE PACKAGE...: a finished folder of the suite that has all of the packages, or nothing.
folder_with() {
  local list place=$cache/$family-$1
  shift
  for list in "$place"-*/etc/superquadric-packages; do
    case $list in *.tmp/*) continue ;; esac
    if [ -f "$list" ] && [ -z "$(LC_ALL=C comm -23 <(printf '%s\n' "$@") "$list")" ]; then
      echo "${list%/etc/*}"
      return
    fi
  done
}

# make_folder SUITE TARGET: a Debian with the package names that come in. Complete or not there at all: it
# is made under another name and renamed. An ordinary user gets it through an archive,
# so that every file belongs to the user (and a plain rm -rf removes it).
make_folder() {
  local suite=$1 target=$2 work=$2.tmp packages options sources
  packages=$(cat)
  rm -rf --one-file-system "$work" || die "cannot remove the unfinished $work"
  own_lists
  sources=$(debian_lines "$suite")
  apt_in folder
  # How this machine fetches (through a proxy, say).
  { apt-config dump Acquire; echo "$anyAge;"; } >"$apt/folder/apt.conf"
  echo "$sources" >"$apt/folder/sources.list"
  options=(--variant=minbase "--include=$(paste -sd, <<<"$packages")"
    "--aptopt=$apt/folder/apt.conf" --dpkgopt=force-unsafe-io '--dpkgopt=path-exclude=/usr/share/man/*' '--dpkgopt=path-exclude=/usr/share/locale/*'
    '--dpkgopt=path-exclude=/usr/share/doc/*' '--dpkgopt=path-include=/usr/share/doc/*/copyright'
    --customize-hook='touch "$1/etc/resolv.conf" "$1/etc/hosts"'
    --customize-hook='rm -rf "$1"/var/lib/apt/lists/* "$1"/var/cache/apt/*')
  # Without lines mmdebstrap takes Debian's public archive.
  set -- "$suite" "$work"
  [ -z "$sources" ] || set -- "$@" "$apt/folder/sources.list"
  say "making a Debian $suite folder in $target (with YADE and a compiler 2-4 minutes, 3 GB)"
  if [ "$(id -u)" -eq 0 ]; then
    mmdebstrap --mode=root "${options[@]}" "$@" >&2
  else
    mkdir -p "$work" &&
      TMPDIR=/var/tmp mmdebstrap --mode=unshare --format=tar "${options[@]}" "$1" - "${@:3}" |
      tar -x -C "$work" --no-same-owner --exclude='./dev/*'
  fi || { rm -rf --one-file-system "$work"; die "the Debian $suite folder could not be made: see the messages above." \
    "What is there stays usable; run the command again once the cause is gone." \
    "Where this machine's archives are not those of Debian $suite, name a file with lines like \"deb ARCHIVE $suite main\" in YADE_APT_SOURCES."; }
  printf '%s\n' "$packages" >"$work/etc/superquadric-packages"
  mv "$work" "$target"
}

# drop_folders SUITE KEEP: remove all folders of the suite but one; those in use (their lock is held) stay until the next time.
drop_folders() {
  local old
  for old in "$cache/$family-$1"-*; do
    case $old in "$2" | *.lock | *.tmp) continue ;; esac
    [ -d "$old" ] || continue
    flock --nonblock --exclusive "$old.lock" rm -rf --one-file-system "$old" "$old.lock" ||
      say "$old is in use; it is removed another time"
  done
}

# use_folder SUITE PACKAGE...: set `folder` to one that has the packages, and hold it: nobody removes it while this command, or the one that takes its
# place, runs. Fails where there is none.
use_folder() {
  folder=$(folder_with "$@")
  [ -n "$folder" ] || return 1
  exec 8>"$folder.lock"
  flock --shared 8
  [ -d "$folder" ]
}

# folder_ready SUITE PACKAGE...: have a folder with the packages and hold it. Its list only grows, so that targets with different needs share one.
folder_ready() {
  local suite=$1 all
  if ! use_folder "$@"; then
    lock "$cache/$family-$suite.lock"
    if ! use_folder "$@"; then
      folder_tools
      all=$({ printf '%s\n' "${@:2}"; cat "$cache/$family-$suite"-*/etc/superquadric-packages 2>/dev/null || true; } | LC_ALL=C sort -u)
      folder=$cache/$family-$suite-$(printf '%s\n' "$recipe" "$suite" "$(dpkg --print-architecture)" "$all" | short_hash)
      make_folder "$suite" "$folder" <<<"$all"
      drop_folders "$suite" "$folder"
      use_folder "$@"
    fi
    unlock
  fi
  enter_folder
}

# enter_folder: set `enter`, the command that runs another one in the folder. The system folders are Debian's (read only), everything else
# is this machine's: home, projects, /tmp with the X11 socket, network, graphics card. So paths mean
# the same inside and outside.
enter_folder() {
  local entry
  enter=(bwrap --proc /proc --dev /dev --dev-bind-try /dev/dri /dev/dri --ro-bind-try /sys /sys
    --dir /run --bind-try /run/user /run/user --bind-try /run/dbus /run/dbus --die-with-parent --chdir "$PWD")
  for entry in "$folder"/*; do
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
  # The folder has no other locale, and unknown ones make Boost and Qt give up.
  enter+=(--setenv LC_ALL C.UTF-8 --unsetenv LANGUAGE --)
}

# debian_ready SET...: a folder of `suite` with YADE and the package sets, and YADE's headers from the archive that it was made of.
debian_ready() {
  local packages
  mapfile -t packages < <(packages_of "$@")
  folder_ready "$suite" "${packages[@]}"
  environment=${folder##*/}
  yadeVersion=$(dpkg-query --admindir="$folder/var/lib/dpkg" -W -f '${source:Version}' yade)
  headers=${YADE_SOURCE:-}
  [ -n "$headers" ] || fetch_headers "$folder" "$yadeVersion"
}
