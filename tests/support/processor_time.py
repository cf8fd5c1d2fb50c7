# SPDX-License-Identifier: BSD-3-Clause
import resource


def of_children():
    """Returns the processor time of all child processes that have ended [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
