#!/usr/bin/env python
"""`nbdev_test` with a process of its own for each notebook, so that one that hangs, crashes, or leaves threads and log levels
behind fails alone. It takes nbdev_test's options. Without `--flags`, the cells that need GStreamer or Chromium run where these
are installed. What fails is tried once more, alone; a notebook that passes then is named."""
import faulthandler, os, signal, sys, time
from multiprocessing import get_context
from multiprocessing.connection import wait

import nbdev.test
from installed import in_browser,installed
import cv2, matplotlib.pyplot, numpy, pymavlink.dialects.v20.all      # noqa: once here, and not in each process

LONGEST = 600   # s for one notebook; then it says where it hangs, and ends
begun = []      # the notebooks that nbdev_test has found
PASSED,FAILED = 60,61           # what `child` ends with; a notebook that ends its process itself, with 0 perhaps, has not passed


def child(test, notebook, options):
    "Test one notebook in this process, and leave with `PASSED` or `FAILED`; threads it left are not waited for"
    os.setpgid(0, 0)
    faulthandler.dump_traceback_later(LONGEST, exit=True)
    passed,_ = test(notebook, **options)
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(PASSED if passed else FAILED)


def start(test, notebook, options):
    "The process that tests `notebook`, and when it was started"
    process = get_context('fork').Process(target=child, args=(test, notebook, options))
    process.start()
    return process,notebook,time.time()


def finish(process, notebook, began):
    "Whether `notebook` passed, and its seconds; its own processes end with it"
    process.join()
    try: os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError: pass
    ended = process.exitcode
    if ended not in (PASSED, FAILED): print(f'{notebook.name}: its process ended with {ended}', file=sys.stderr, flush=True)
    return ended == PASSED,time.time()-began


def run(test, notebooks, workers, options):
    "What `finish` says of each of `notebooks`, `workers` at a time"
    waiting,busy,results = list(notebooks),{},{}
    try:
        while waiting or busy:
            while len(busy) < workers:
                browsing = any(in_browser(notebook) for _,notebook,_ in busy.values())
                ready = next((notebook for notebook in waiting if not (browsing and in_browser(notebook))), None)
                if ready is None: break
                waiting.remove(ready)
                started = start(test, ready, options)
                busy[started[0].sentinel] = started
            for sentinel in wait(list(busy)):
                started = busy.pop(sentinel)
                results[started[1]] = finish(*started)
        return results
    finally:
        for process,*_ in busy.values(): process.kill()


def parallel(test, notebooks, n_workers, pause, **options):
    "fastcore's `parallel`, as nbdev_test calls it: what `test` gives for each notebook, in their order"
    begun.extend(notebooks)
    def late(notebook): return not (in_browser(notebook) or 'explanations' in notebook.parts)
    longest = sorted(notebooks, key=late)                               # those of a browser, which take turns, begin first
    results = run(test, longest, max(n_workers*3//2, 1), options)       # for half of its time and more a notebook waits
    again = [notebook for notebook in notebooks if not results[notebook][0]]
    if len(again) > 8: again = []           # that is no accident
    results.update(run(test, again, 1, options))
    for notebook in again:
        print(f"{notebook.name}: failed {'first, and passed the second time' if results[notebook][0] else 'twice'}", flush=True)
    return [results[notebook] for notebook in notebooks]


if __name__ == '__main__':
    nbdev.test.parallel = parallel
    if '--flags' not in sys.argv: sys.argv += ['--flags', ' '.join(installed())]
    nbdev.test.nbdev_test()
    sys.exit(not begun)         # a path that does not exist is not a success
