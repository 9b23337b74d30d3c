# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A Debian root that holds a real Blender, made once in the cache by mmdebstrap; nothing is installed on the machine.

It is entered by a mount namespace in which its /usr stands in place of the machine's own. Home, /tmp and the checkout
stay where they are, nothing is left mounted, and an ordinary user can do it where user namespaces are allowed.
"""

import hashlib
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from . import CACHE, SetupError, apt
from .steps import locked, step

ROOT = CACHE / "blender-root"
STAMP = CACHE / "blender-root.packages"  # beside the root: an ordinary user cannot write inside his
SUITE = "sid"  # Debian's stable has Blender 4.3, too old; sid has 5.2 LTS
PACKAGES = (
    *("blender", "python3-numpy", "python3-cattr", "python3-requests"),
    *("xvfb", "xauth", "imagemagick", "libgl1-mesa-dri", "libegl1", "fonts-dejavu-core"),
)
OMITTED = ("/usr/share/doc/*", "/usr/share/man/*", "/usr/share/locale/*")
KEYS = Path("usr/share/keyrings/debian-archive-keyring.gpg")
WAY_OUT = "Or install Blender 4.5 or newer and name its executable in BLENDER."

MOUNT_AND_RUN = """
for part in etc/ld.so.cache etc/alternatives usr; do mount --bind "$0/$part" "/$part" || exit 125; done
exec "$@"
"""


def enter():
    """The words in front of a command that is to run in the root, or None where this user may not enter."""
    if namespaces_allowed():
        return (*namespace(), "sh", "-c", MOUNT_AND_RUN, str(ROOT))
    if shutil.which("proot"):  # traces its children: slower to start, and needs no right, as in a locked container
        return ("proot", *(f"--bind={ROOT}/{part}:/{part}" for part in ("usr", "etc/alternatives", "etc/ld.so.cache")))
    return None


def namespace():
    map_user = [] if os.geteuid() == 0 else ["--map-root-user"]
    return ("unshare", *map_user, "--mount", "--propagation", "private")


def namespaces_allowed():
    try:
        return not subprocess.run([*namespace(), "true"], capture_output=True).returncode
    except OSError:
        return False


def there():
    return ROOT.exists() and STAMP.exists() and STAMP.read_text() == wanted()


def wanted():
    return hashlib.sha256(repr((SUITE, PACKAGES, OMITTED)).encode()).hexdigest()


def make():
    """Make the root if it is not there, or refuse with the way out."""
    if not namespaces_allowed():
        if os.geteuid():
            raise SetupError(
                "The real Blender needs a user namespace, which this machine, or a chroot, forbids to this user. "
                f"Run this as root, or on Ubuntu: sudo sysctl kernel.apparmor_restrict_unprivileged_userns=0. {WAY_OUT}"
            )
        if not shutil.which("proot"):
            apt.install(["proot"], "This container forbids namespaces; the real Blender is run by proot instead.")
    elif os.geteuid() and not shutil.which("newuidmap"):
        raise SetupError(f"The real Blender needs the package uidmap: sudo apt-get install uidmap. {WAY_OUT}")
    with locked(CACHE / "blender-root.lock"):
        if not there():
            with tempfile.TemporaryDirectory(prefix="sweep-root-") as folder:
                make_in_part(Path(folder))


def make_in_part(folder):
    keyring, path = tools(folder)
    part = CACHE / "blender-root.part"
    remove(part)
    options = [f"--dpkgopt=path-exclude={pattern}" for pattern in OMITTED]
    options += ["--variant=minbase", f"--include={','.join(PACKAGES)}", "--aptopt=Acquire::Check-Valid-Until false"]
    try:
        title = "real Blender, from Debian's archive, 1.1 GB, about a minute"
        command = ["mmdebstrap", *keyring, *options, SUITE, part]
        step(title, command, WAY_OUT, env={**os.environ, "PATH": path})
    except SetupError:
        remove(part)
        raise
    STAMP.unlink(missing_ok=True)
    remove(ROOT)
    part.rename(ROOT)
    STAMP.write_text(wanted())


def tools(folder):
    """Debian's keys, as an option, and a PATH with mmdebstrap: the machine's own, or unpacked into a folder."""
    names = [] if shutil.which("mmdebstrap") else ["mmdebstrap"]
    names += [] if Path("/", KEYS).exists() else ["debian-archive-keyring"]
    if names:
        apt.unpack(names, folder, WAY_OUT)
    keyring = [] if Path("/", KEYS).exists() else [f"--keyring={folder / KEYS}"]
    return keyring, os.pathsep.join([os.environ.get("PATH", os.defpath), str(folder / "usr" / "bin")])


def remove(folder):
    """Remove a root: an ordinary user's belongs to his subordinate users."""
    if folder.exists():
        as_user = [] if os.geteuid() == 0 else ["unshare", "--map-root-user", "--map-auto"]
        subprocess.run([*as_user, "rm", "-rf", "--one-file-system", folder], check=True)
