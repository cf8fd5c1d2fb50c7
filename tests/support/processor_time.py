# SPDX-License-Identifier: BSD-3-Clause
import resource


def of_children():
    """Processor time of all programs that this one has waited for [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
