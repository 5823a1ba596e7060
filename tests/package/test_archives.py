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


def lines(targets, distributions, call, **variables):
    """What a function of tools/setup/archive.sh says on a machine with these index targets, without the keyrings (which differ between machines)."""
    script = f"""
set -Eeuo pipefail
. tools/setup/common.sh
. tools/setup/archive.sh
apt-get() {{ cat <<'TARGETS'
{chr(10).join(targets)}
TARGETS
}}
distributions() {{ echo '{distributions}'; }}
keyring() {{ echo "[$2]"; }}
aptOptions=()
{call}
"""
    result = subprocess.run(['bash'], input=script, cwd=project, capture_output=True, text=True, check=True,
                            env={'HOME': '/nowhere', 'PATH': '/usr/bin:/bin', **variables})
    return result.stdout.splitlines()


def test_debianOfAnotherSuite():
    """The machine's own archives with the other name; neither backports nor what is not Debian's."""
    assert lines(DEBIAN, 'debian ', 'debian_lines trixie') == [
        'deb [debian] http://a.example/debian/ trixie main', 'deb [debian] http://a.example/debian/ trixie-updates main',
        'deb [debian] http://a.example/security/ trixie-security main']


@pytest.mark.parametrize('targets, distributions', [(UBUNTU, 'ubuntu debian'), (MINT, 'linuxmint ubuntu debian')])
def test_ubuntusArchiveIsNotTakenForDebians(targets, distributions):
    """It has no trixie. Without a line mmdebstrap takes Debian's public archive."""
    assert lines(targets, distributions, 'debian_lines trixie') == []


def test_ubuntuThatKnowsADebianArchiveTakesThat():
    assert lines([*UBUNTU, DEBIAN[0]], 'ubuntu debian', 'debian_lines trixie') == ['deb [debian] http://a.example/debian/ trixie main']


def test_theMachinesOwnYade():
    """Its sources come from where its packages come from."""
    assert lines(UBUNTU, 'ubuntu debian', 'own_sources') == [
        'deb-src [ubuntu] http://u.example/ubuntu/ resolute main', 'deb-src [ubuntu] http://u.example/ubuntu/ resolute universe']


def test_aFileOfTheUsers(tmp_path):
    file = tmp_path / 'debian.list'
    file.write_text('# Debian\ndeb [signed-by=/k.gpg] http://c.example/debian trixie main\n', encoding='utf-8')
    assert lines(UBUNTU, 'ubuntu debian', 'debian_lines trixie', YADE_APT_SOURCES=str(file)) == [
        'deb [signed-by=/k.gpg] http://c.example/debian trixie main']
