# The environment on a YADE of the user's own, built from source, that YADE_EXECUTABLE names (sourced by tools/env): the user's shell
# as it is, for whoever has built a YADE has its compiler and its libraries as well. Nothing is installed; what is missing, CMake says.
# shellcheck shell=bash disable=SC2034,SC2154

own_ready() {
  [ -x "$YADE_EXECUTABLE" ] || die "YADE_EXECUTABLE=$YADE_EXECUTABLE is not a program. Name the yade that your build has installed: PREFIX/bin/yade..."
  [ -n "${YADE_SOURCE:-}" ] || die "YADE_EXECUTABLE needs YADE_SOURCE as well: the source tree from which that YADE was built."
  YADE_EXECUTABLE=$(realpath --no-symlinks "$YADE_EXECUTABLE")
  # The program has its version, its features and its place written in it.
  environment="own-$YADE_EXECUTABLE-$(short_hash <"$YADE_EXECUTABLE")"
  yadeVersion=
  headers=$YADE_SOURCE
  enter=()
}
