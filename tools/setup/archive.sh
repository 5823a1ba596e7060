# The distribution's package archives as this machine knows them (sourced by tools/env).
#
# Everything is asked of apt itself, which understands every way of writing its sources, and looked up
# in lists of our own in the cache, so that neither root nor a change to the machine is needed.
# shellcheck shell=bash disable=SC2016,SC2034,SC2154

# apt_in DIRECTORY: the options that make apt keep its lists and downloads in a directory.
apt_in() {
  mkdir -p "$1/lists/partial" "$1/archives/partial"
  aptOptions=(-o "Dir::State::Lists=$1/lists" -o "Dir::Cache=$1/" -o Debug::NoLocking=true
    -o "APT::Sandbox::User=$(id -un)" -o Acquire::Languages=none)
}

# distributions: this machine's own one and those that it derives from, by their names in /etc/os-release.
distributions() { (. /etc/os-release && echo "$ID ${ID_LIKE:-}"); }

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
# they are filled (containers often come without), else fresh ones in the cache.
own_lists() {
  aptOptions=()
  [ -n "$(own_repositories)" ] && return
  apt_in "$cache/apt/machine"
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

# own_lines TYPE: this machine's archives as lines of a sources.list.
own_lines() {
  local uri release component signedBy
  own_repositories | while read -r uri release _ component signedBy; do
    echo "$1 $(keyring "$signedBy" "$(distributions | cut -d' ' -f1)") $uri $release $component"
  done
}

# debian_lines TYPE SUITE: Debian's archives as this machine knows them, with the suite's name in the place of the codename; only the
# release itself, its updates and its security fixes are kept. A machine that knows none (Ubuntu, say) takes Debian's public name.
debian_lines() {
  local type=$1 suite=$2 known uri release codename component signedBy
  known=$(repositories debian)
  [ -n "$known" ] || known=$(printf 'http://deb.debian.org/%s stable stable%s main -\n' debian '' debian -updates debian-security -security)
  while read -r uri _ codename component signedBy; do
    case $codename in
      *-*) release=$suite-${codename#*-} ;;
      *) release=$suite ;;
    esac
    case $release in
      "$suite" | "$suite-updates" | "$suite-security")
        echo "$type $(keyring "$signedBy" debian) $uri $release $component" ;;
    esac
  done <<<"$known"
}

# source_lines TYPE SUITE: where the suite's packages (TYPE deb) or sources (deb-src) are, as lines of a sources.list.
source_lines() {
  if [ -n "${YADE_APT_SOURCES:-}" ]; then
    sed -n "s/^deb /$1 /p" "$YADE_APT_SOURCES"
  elif [ "$2" = "$(machine_suite)" ]; then
    own_lines "$1"
  else
    debian_lines "$1" "$2" | sort -u
  fi
}

# suite_lists SUITE: write the suite's source archive list, point `aptOptions` to it and fetch its index.
suite_lists() {
  local place=$cache/apt/$1 log
  own_lists
  source_lines deb-src "$1" >"$cache/sources-$1.tmp"
  [ -s "$cache/sources-$1.tmp" ] || die "no archive for \"$1\" follows from this machine's apt sources (/etc/apt)." \
    "Name a file with lines like \"deb ARCHIVE $1 main\" in the variable YADE_APT_SOURCES."
  apt_in "$place"
  mv "$cache/sources-$1.tmp" "$place/sources.list"
  aptOptions+=(-o "Dir::Etc::SourceList=$place/sources.list" -o Dir::Etc::SourceParts=-)
  log=$place/update.log
  if ! apt-get "${aptOptions[@]}" -o APT::Update::Error-Mode=any update >"$log" 2>&1; then
    cat "$log" >&2
    ! grep -q 'NO_PUBKEY\|not signed\|Missing key' "$log" ||
      die "this machine does not have the key that signs Debian $1. Please ask the administrator for:" \
        "apt-get install --only-upgrade debian-archive-keyring"
    die "the source archive of \"$1\" cannot be read: see apt's messages above."
  fi
}

# fetch_headers SUITE VERSION: set `headers` to a folder with YADE's headers, taken from the source package
# of a version (Debian's number; nothing of the source is built).
fetch_headers() {
  local version=$2 target=$cache/yade-$2 work=$cache/yade-$2.tmp
  headers=$target
  [ -d "$target" ] && return
  say "fetching YADE's headers: the source package of exactly version $version (14 MB; nothing of it is built)"
  suite_lists "$1"
  rm -rf "$work"
  mkdir -p "$work/tree"
  (cd "$work" && apt-get "${aptOptions[@]}" -qq source --tar-only --download-only "yade=$version" >&2) ||
    die "apt has no source of YADE $version (a binary of another version is installed?)." \
      "Unpack it yourself and name the folder in the variable YADE_SOURCE."
  "${enter[@]}" tar -x -C "$work/tree" --strip-components=1 -f "$work"/yade_*.orig.tar.* --wildcards '*.hpp' '*.h' '*.ipp' '*/RELEASE'
  mv "$work/tree" "$target"
  rm -rf "$work" "$cache/apt"
}
