"""Print what a frame of the live page takes of the main thread, at each pace of the run.

python documentation/live/frames.py FOLDER
"""

import sys

from browser import chromium, open_page, served, size_of, wait

WIDTH, HEIGHT = 1280, 900
FRAMES = 300
PACES = ("full", "stance", "slow", "slowest")


def durations(driver, pace):
    """Durations of `FRAMES` frames at a pace, ms, in rising order."""
    driver.execute_script("document.getElementById('pace').value = arguments[0]", pace)
    driver.execute_script("tdmfSlip.player.play(true); tdmfSlip.player.frames.length = 0")
    wait(driver, f"tdmfSlip.player.frames.length >= {FRAMES}", "frames")
    return sorted(driver.execute_script("return tdmfSlip.player.frames"))


def main(folder):
    """Measure the page in a folder."""
    with served(folder) as address, chromium(WIDTH, HEIGHT) as driver:
        open_page(driver, address)
        print(
            f"live page: {size_of(folder) / 1e3:.0f} kB; one frame, core and drawing, at {WIDTH} x {HEIGHT}:"
        )
        for pace in PACES:
            found = durations(driver, pace)
            median, most = found[len(found) // 2], found[int(0.99 * len(found))]
            print(
                f"  pace {pace:8s} median {median:5.2f} ms, 99 % below {most:5.2f} ms, of {len(found)} frames"
            )


if __name__ == "__main__":
    main(*sys.argv[1:])
