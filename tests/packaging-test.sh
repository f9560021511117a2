#!/usr/bin/env bash
# The installed program: everything is in its place, describes itself as it is, and works from there.
# Usage: packaging-test.sh BUILD-FOLDER SOURCE-FOLDER
set -euo pipefail
build=$1 source=$2
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
fail() { echo "packaging: $*" >&2; exit 1; }

cmake --install "$build" --prefix "$root" >/dev/null
share=$root/share
for file in bin/stromar bin/stromar-cli share/man/man1/stromar.1 share/man/man1/stromar-cli.1 \
  share/applications/org.stromar.Stromar.desktop share/mime/packages/org.stromar.Stromar.xml \
  share/icons/hicolor/scalable/apps/org.stromar.Stromar.svg share/stromar/docs/manual.md \
  share/thumbnailers/org.stromar.Stromar.thumbnailer share/stromar/docs/images/presets/apple.png; do
  [ -s "$root/$file" ] || fail "$file is missing"
done

# It takes its data from where it is installed.
env -u STROMAR_DATA "$root/bin/stromar-cli" export "$share/stromar/presets/quaking_aspen.tree" -o "$root/a.obj" --quiet --model simple --set LeafTexture=
cmp "$share/stromar/textures/leaf.png" "$root/a_leaf.png" || fail "not its own leaf"

# File managers get pictures, without a display.
thumbnail=$(sed -n 's/^Exec=//p' "$share/thumbnailers/org.stromar.Stromar.thumbnailer")
thumbnail=${thumbnail//%i/$share/stromar/presets/sapling.tree}
thumbnail=${thumbnail//%o/$root/thumbnail.png}
env -u DISPLAY PATH="$root/bin:$PATH" sh -c "${thumbnail//%s/64}" || fail "no thumbnail"
file "$root/thumbnail.png" | grep -q '64 x 64' || fail "the thumbnail has another size"

# The manual pages know every option.
for option in $(env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM "$root/bin/stromar" --help | grep -o -- '--[a-z-]*' | sort -u); do
  case $option in --help-all | --version | --help) continue ;; esac
  grep -q -- "${option//-/\\\\-}" "$share/man/man1/stromar.1" || fail "stromar.1 does not know $option"
done
for command in info structure check export render texture params formats; do
  grep -q "^.SS $command" "$share/man/man1/stromar-cli.1" || fail "stromar-cli.1 does not know $command"
done

# Completion works in bash.
bash -c "source '$share/bash-completion/completions/stromar-cli'
  complete_words() { COMP_WORDS=(\"\$@\"); COMP_CWORD=\$((\${#COMP_WORDS[@]} - 1)); _stromar_cli 2>/dev/null; echo \"\${COMPREPLY[*]}\"; }
  [ \"\$(complete_words stromar-cli exp)\" = export ] || exit 1
  [ \"\$(complete_words stromar-cli info --model s)\" = simple ] || exit 2
  [ \"\$(complete_words stromar-cli info --lo)\" = --lod ] || exit 3
  case \$(complete_words stromar-cli info --set 1Down) in *1DownAngle=*1DownAngleV=*) ;; *) exit 4 ;; esac" ||
  fail "completion fails ($?)"

# The package knows what it needs.
(cd "$build" && cpack -B "$root/deb" >"$root/cpack.log" 2>&1) || { cat "$root/cpack.log"; fail "cpack fails"; }
depends=$(dpkg-deb -f "$root"/deb/*.deb Depends)
for library in libqt6widgets6 libopenscenegraph161 libassimp5 libqt6svg6; do
  case $depends in *"$library"*) ;; *) fail "the package does not depend on $library" ;; esac
done

if command -v appstreamcli >/dev/null; then
  appstreamcli validate --no-net "$share/metainfo/org.stromar.Stromar.metainfo.xml" || fail "the metainfo is not valid"
else
  echo "packaging: no appstreamcli, the metainfo is not checked"
fi
if command -v desktop-file-validate >/dev/null; then
  desktop-file-validate "$share/applications/org.stromar.Stromar.desktop" || fail "the desktop file is not valid"
else
  echo "packaging: no desktop-file-validate, the desktop file is not checked"
fi
