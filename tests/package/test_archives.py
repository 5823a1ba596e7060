"""Where tools/env looks for packages, on machines of several kinds (played by functions in the place of apt-get and of /etc/os-release)."""
import subprocess
from pathlib import Path

import pytest

project = Path(__file__).resolve().parents[2]
# ORIGIN|REPO_URI|RELEASE|CODENAME|COMPONENT|SIGNED_BY, as apt-get indextargets tells them.
DEBIAN = ['Debian|http://a.example/debian/|bookworm|bookworm|main|$(SIGNED_BY)',
          'Debian|http://a.example/debian/|bookworm-updates|bookworm-updates|main|$(SIGNED_BY)',
          'Debian|http://a.example/debian/|bookworm-backports|bookworm-backports|main|$(SIGNED_BY)',
          'Debian|http://a.example/security/|bookworm-security|bookworm-security|main|/dev/null',
          'Somebody|http://b.example/apt/|stable|stable|main|/b.gpg']
UBUNTU = ['Ubuntu|http://u.example/ubuntu/|resolute|resolute|main|/u.gpg', 'Ubuntu|http://u.example/ubuntu/|resolute|resolute|universe|/u.gpg',
          'Somebody|http://b.example/apt/|stable|stable|main|/b.gpg']
MINT = ['linuxmint|http://m.example/|zena|zena|main|$(SIGNED_BY)', *UBUNTU]


def lines(targets, distributions, machine, type_, suite, **variables):
    """The sources.list that a machine with these index targets gets for a suite, without the keyrings (which differ from machine to machine)."""
    script = f"""
set -Eeuo pipefail
. tools/setup/common.sh
. tools/setup/archive.sh
apt-get() {{ cat <<'TARGETS'
{chr(10).join(targets)}
TARGETS
}}
distributions() {{ echo '{distributions}'; }}
machine_suite() {{ echo {machine}; }}
keyring() {{ echo "[$2]"; }}
aptOptions=()
source_lines {type_} {suite}
"""
    result = subprocess.run(['bash'], input=script, cwd=project, capture_output=True, text=True, check=True,
                            env={'HOME': '/nowhere', 'PATH': '/usr/bin:/bin', **variables})
    return result.stdout.splitlines()


def test_debianOfAnotherSuite():
    """The machine's own archives with the other name; neither backports nor what is not Debian's."""
    assert lines(DEBIAN, 'debian ', 'bookworm', 'deb', 'trixie') == [
        'deb [debian] http://a.example/debian/ trixie main', 'deb [debian] http://a.example/debian/ trixie-updates main',
        'deb [debian] http://a.example/security/ trixie-security main']


@pytest.mark.parametrize('targets, distributions', [(UBUNTU, 'ubuntu debian'), (MINT, 'linuxmint ubuntu debian')])
def test_ubuntuTakesDebiansPublicArchive(targets, distributions):
    assert lines(targets, distributions, 'noble', 'deb', 'trixie') == [
        'deb [debian] http://deb.debian.org/debian trixie main', 'deb [debian] http://deb.debian.org/debian trixie-updates main',
        'deb [debian] http://deb.debian.org/debian-security trixie-security main']


def test_ubuntuThatKnowsADebianArchiveTakesThat():
    assert lines([*UBUNTU, DEBIAN[0]], 'ubuntu debian', 'noble', 'deb-src', 'trixie') == ['deb-src [debian] http://a.example/debian/ trixie main']


def test_theMachinesOwnSuite():
    """The sources of a YADE that the machine has itself come from where its packages come from, unchanged."""
    assert lines(UBUNTU, 'ubuntu debian', 'resolute', 'deb-src', 'resolute') == [
        'deb-src [ubuntu] http://u.example/ubuntu/ resolute main', 'deb-src [ubuntu] http://u.example/ubuntu/ resolute universe']


def test_aFileOfTheUsers(tmp_path):
    file = tmp_path / 'debian.list'
    file.write_text('# Debian\ndeb [signed-by=/k.gpg] http://c.example/debian trixie main\n', encoding='utf-8')
    for type_ in ('deb', 'deb-src'):
        assert lines(UBUNTU, 'ubuntu debian', 'noble', type_, 'trixie', YADE_APT_SOURCES=str(file)) == [
            f'{type_} [signed-by=/k.gpg] http://c.example/debian trixie main']
