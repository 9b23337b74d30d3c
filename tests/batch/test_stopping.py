# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands that are ended by a signal, and disks that are full: outputs are written whole or not at all."""

import errno
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import sweep_addon as sw
from sweep_addon.batch import export
from sweep_addon.batch.stopping import STOPPED

CHECKOUT = Path(__file__).parents[2]
SWEEP = [sys.executable, "-m", "sweep_addon"]
HEEDING = "import os, signal, sys; signal.signal(signal.SIGINT, signal.SIG_DFL); os.execv(sys.argv[1], sys.argv[1:])"
POSIX = pytest.mark.skipif(os.name != "posix", reason="signals of other systems end a process at once")
SHAPE = sw.GeneralizedCylinder(sw.contours.Circle(points=800), sw.trajectories.Helix(), samples=sw.sampling.Count(2000))


def stopped(arguments, number, until):
    """End a command by a signal once something is so: its exit code, what it printed and what it said."""
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    # tests that run in the background of a script ignore Ctrl-C, and so would the command
    heeding = [sys.executable, "-c", HEEDING, *SWEEP, *map(str, arguments)]
    process = subprocess.Popen(heeding, cwd=CHECKOUT, **pipes, start_new_session=True)
    give_up = time.monotonic() + 60
    while not until(process) and process.poll() is None and time.monotonic() < give_up:
        time.sleep(0.01)
    process.send_signal(number)
    told = process.communicate(timeout=60)
    return process.returncode, *told


@POSIX
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_while_a_model_is_written_leaves_nothing(tmp_path, blender_module, number):
    job, out = tmp_path / "tube.toml", tmp_path / "out"
    job.write_text(sw.dump(SHAPE))
    part = out / ".sweep-tube.glb.part"
    assert stopped(["build", job, "--output", out / "tube.glb"], number, lambda _: part.exists()) == (1, "", STOPPED)
    assert not list(out.iterdir())


@POSIX
def test_a_signal_ends_what_many_jobs_have_begun_and_begins_nothing(tmp_path, blender_module):
    jobs, out = [tmp_path / f"tube_{number}.toml" for number in range(3)], tmp_path / "out"
    for job in jobs:
        job.write_text(sw.dump(SHAPE))
    part = out / ".sweep-tube_0.glb.part"
    code, printed, said = stopped(
        ["build", *jobs, "--output-dir", out, "--format", "glb"], signal.SIGTERM, lambda _: part.exists()
    )
    assert (code, printed) == (1, "") and said.endswith(STOPPED)
    assert not list(out.iterdir())


@POSIX
def test_a_command_leaves_no_temporary_files(tmp_path, blender_module):
    """Blender's module has a folder of its own, which it takes away only where it is left to end by itself."""
    job, temporary = tmp_path / "tube.toml", tmp_path / "temporary"
    job.write_text(sw.dump(sw.GeneralizedCylinder()))
    temporary.mkdir()
    command = [*SWEEP, "build", str(job), "--output", str(tmp_path / "tube.stl")]
    done = subprocess.run(command, cwd=CHECKOUT, env={**os.environ, "TMPDIR": str(temporary)}, capture_output=True)
    assert done.returncode == 0 and not list(temporary.iterdir())


@POSIX
def test_a_signal_that_whoever_started_it_ignores_is_ignored():
    script = "import signal; from sweep_addon.batch.stopping import heed; heed(); signal.raise_signal(signal.SIGINT)"
    command = [sys.executable, "-c", f"{script}; import time; time.sleep(0.5); print('goes on')"]
    ignoring = ["sh", "-c", 'trap "" INT; exec "$@"', "sh", *command]
    done = subprocess.run(ignoring, cwd=CHECKOUT, capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (0, "goes on\n")


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="needs to know when signals are heeded")
def test_a_signal_ends_a_command_that_waits_for_its_input():
    def heeds(process):
        status = Path(f"/proc/{process.pid}/status").read_text().split("SigCgt:")[1]
        return int(status.split()[0], 16) >> (signal.SIGTERM - 1) & 1

    assert stopped(["derive", "-"], signal.SIGTERM, heeds) == (1, "", STOPPED)


def test_what_fills_the_disk_is_not_moved_to_its_place(tmp_path, monkeypatch):
    output = tmp_path / "tube.stl"
    output.write_text("as it was")

    def fsync(file):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(export.os, "fsync", fsync)
    with pytest.raises(OSError, match="No space left") as error, export.whole(output) as path:
        path.write_text("cut sh")
    assert error.value.filename == str(output)
    assert output.read_text() == "as it was" and list(tmp_path.iterdir()) == [output]


def test_a_folder_that_takes_nothing_is_told_of_by_the_name_of_the_output(tmp_path, monkeypatch):
    output, make = tmp_path / "tube.stl", Path.mkdir

    def mkdir(path, *options, **more):
        if path.suffix == ".part":
            raise PermissionError(errno.EACCES, "Permission denied", str(path))
        make(path, *options, **more)

    monkeypatch.setattr(Path, "mkdir", mkdir)
    with pytest.raises(PermissionError) as error, export.whole(output):
        pass
    assert error.value.filename == str(output)


@pytest.mark.parametrize("suffix", [".stl", ".obj", ".ply", ".glb"])
def test_a_full_disk_leaves_what_was_there(tmp_path, blender_module, suffix):
    """A disk of 200 kB, in a namespace of its own."""
    job, disk = tmp_path / "tube.toml", tmp_path / "disk"
    job.write_text(sw.dump(sw.GeneralizedCylinder()))
    disk.mkdir()
    user = [] if os.geteuid() == 0 else ["--map-root-user"]
    within = ["unshare", *user, "--mount", "sh", "-c", 'mount -t tmpfs -o size=200k tmpfs "$0" && "$@"', str(disk)]
    if not shutil.which("unshare") or subprocess.run([*within, "true"], capture_output=True).returncode:
        pytest.skip("needs a disk of its own, and this machine forbids namespaces")
    output = disk / f"tube{suffix}"
    script = 'echo as it was > "$0"; "$@"; code=$?; cat "$0"; ls -A "${0%/*}"; exit $code'
    command = [*within, "sh", "-c", script, str(output), *SWEEP, "build", str(job), "--output", str(output)]
    done = subprocess.run(command, cwd=CHECKOUT, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (1, f"{output}: No space left on device\n")
    assert done.stdout == f"as it was\n{output.name}\n"
