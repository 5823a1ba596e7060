# The distribution's package archives as this machine knows them (sourced by tools/env).
#
# Everything is asked of apt itself, which understands every way of writing its sources, and looked up
# in lists of our own, so that neither root nor a change to the machine is needed.
# shellcheck shell=bash disable=SC2016,SC2034,SC2154

# apt_in NAME: the options that make apt keep its lists and downloads in a folder of this command's own, `apt`/NAME.
apt_in() {
  if [ -z "${apt:-}" ]; then
    mkdir -p "$cache"
    apt=$(mktemp -d "$cache/apt-XXXXXX")
    trap 'rm -rf "$apt"' EXIT
  fi
  mkdir -p "$apt/$1/lists/partial" "$apt/$1/archives/partial"
  aptOptions=(-o "Dir::State::Lists=$apt/$1/lists" -o "Dir::Cache=$apt/$1/" -o Debug::NoLocking=true
    -o "APT::Sandbox::User=$(id -un)" -o Acquire::Languages=none)
}

# forget_lists: remove what `apt_in` keeps; to be called before another program takes this one's place.
forget_lists() { [ -z "${apt:-}" ] || rm -rf "$apt"; }

# repositories DISTRIBUTION...: a line `URI RELEASE CODENAME COMPONENT SIGNED_BY` for each part of the distributions'
# archives that this machine uses (third parties' archives are left out by their Origin).
repositories() {
  apt-get "${aptOptions[@]}" indextargets 'Created-By: Packages' \
    --format '$(ORIGIN)|$(REPO_URI)|$(RELEASE)|$(CODENAME)|$(COMPONENT)|$(SIGNED_BY)' |
    awk -F'|' -v want=" $* " 'index(want, " " tolower($1) " ") {print $2, $3, $4, $5, ($6 ~ "^/" ? $6 : "-")}' | sort -u
}

# own_repositories: those of this machine's distribution.
own_repositories() {
  local names
  read -ra names <<<"$(distributions)"
  repositories "${names[@]}"
}

# own_lists: point `aptOptions` to lists that know this machine's archives: the machine's own ones where
# they are filled (containers often come without), else fresh ones.
own_lists() {
  aptOptions=()
  [ -n "$(own_repositories)" ] && return
  apt_in machine
  [ -n "$(own_repositories)" ] && return
  say "asking this machine's package archives what they have (its own lists are empty)"
  apt-get "${aptOptions[@]}" update >&2 || die "apt-get update failed: see its messages above."
  [ -n "$(own_repositories)" ] || die "this machine's apt sources (/etc/apt) name no archive of its own distribution." \
    "Add one, or name a file of Debian $debianSuite's sources in the variable YADE_APT_SOURCES."
}

# yade_candidate: the version of YADE that this machine's archives offer (or that is installed), or nothing.
yade_candidate() {
  apt-cache "${aptOptions[@]}" policy yade 2>/dev/null | sed -n 's/^  Candidate: \([0-9].*\)/\1/p'
}

# keyring SIGNED_BY DISTRIBUTION: the `[signed-by=...]` option with the key of the machine's own entry, or
# with the distribution's keyring where apt does not tell.
keyring() {
  local file
  for file in "$1" "/usr/share/keyrings/$2-archive-keyring".{pgp,gpg}; do
    if [ -f "$file" ]; then
      echo "[signed-by=$file]"
      return
    fi
  done
}

# own_sources: this machine's archives as `deb-src` lines of a sources.list.
own_sources() {
  local uri release component signedBy
  own_repositories | while read -r uri release _ component signedBy; do
    echo "deb-src $(keyring "$signedBy" "$(distributions | cut -d' ' -f1)") $uri $release $component"
  done
}

# debian_lines SUITE: `deb` lines of a sources.list for a suite of Debian: from the file that the user names, or from Debian's archives as this machine
# knows them, with the suite's name in the place of the codename; only the release itself, its updates and its security fixes are kept. Nothing on a
# machine that knows none (Ubuntu, say): mmdebstrap then takes Debian's public archive.
debian_lines() {
  local uri codename component signedBy suffix
  if [ -n "${YADE_APT_SOURCES:-}" ]; then
    sed -n "s/^deb /deb /p" "$YADE_APT_SOURCES"
    return
  fi
  repositories debian | while read -r uri _ codename component signedBy; do
    suffix=${codename#"${codename%%-*}"}
    case $suffix in
      '' | -updates | -security) echo "deb $(keyring "$signedBy" debian) $uri $1$suffix $component" ;;
    esac
  done | sort -u
}

# An archive may lie behind this machine's clock (a mirror, a snapshot), which apt would refuse for a suite that still changes. What it holds is signed
# all the same.
anyAge='Acquire::Check-Valid-Until "false"'

# read_sources NAME: fetch the index of the archives whose `deb-src` lines come in, and point `aptOptions` to it.
read_sources() {
  local log
  apt_in "$1"
  cat >"$apt/$1/sources.list"
  aptOptions+=(-o "Dir::Etc::SourceList=$apt/$1/sources.list" -o Dir::Etc::SourceParts=- -o Acquire::Check-Valid-Until=false)
  log=$apt/$1/update.log
  if ! apt-get "${aptOptions[@]}" -o APT::Update::Error-Mode=any update >"$log" 2>&1; then
    cat "$log" >&2
    ! grep -q 'NO_PUBKEY\|not signed\|Missing key' "$log" ||
      die "this machine does not have the key that signs Debian $1. Please ask the administrator for:" \
        "apt-get install --only-upgrade debian-archive-keyring"
    die "the source archive of \"$1\" cannot be read: see apt's messages above."
  fi
}

# fetch_headers PLACE VERSION: set `headers` to a folder with YADE's headers, taken from the source package of a version (Debian's number; nothing of
# the source is built). PLACE is the Debian folder whose archives have it, or `machine`.
fetch_headers() {
  local place=$1 version=$2 work=$cache/yade-$2.tmp
  headers=$cache/yade-$version
  [ ! -d "$headers" ] || return 0
  lock "$headers.lock"
  if [ ! -d "$headers" ]; then
    say "fetching YADE's headers: the source package of exactly version $version (14 MB; nothing of it is built)"
    if [ "$place" = machine ]; then
      own_lists
      read_sources machine-sources < <(own_sources)
    else
      # A folder need not have both kinds of files.
      read_sources "${place##*/}" < <(sed -n 's/^deb /deb-src /p' "$place"/etc/apt/sources.list{,.d/*.list} 2>/dev/null || true)
    fi
    rm -rf "$work"
    mkdir -p "$work/tree"
    (cd "$work" && apt-get "${aptOptions[@]}" -qq source --tar-only --download-only "yade=$version" >&2) ||
      die "apt has no source of YADE $version (a binary of another version is installed?)." \
        "Unpack it yourself and name the folder in the variable YADE_SOURCE."
    "${enter[@]}" tar -x -C "$work/tree" --strip-components=1 -f "$work"/yade_*.orig.tar.* --wildcards '*.hpp' '*.h' '*.ipp' '*/RELEASE'
    mv "$work/tree" "$headers"
    rm -rf "$work"
  fi
  unlock
}
