# SPDX-License-Identifier: BSD-3-Clause
"""The names of PyTorch that netloft.torch and its test use, for machines without it: one call of a Function is
differentiated, with the signatures of the documentation of torch 1.13."""
import types

import numpy

float64 = numpy.float64


class Tensor:
    def __init__(self, values, dtype=float64, requires_grad=False):
        self.values, self.requires_grad, self.made_by = numpy.array(values, dtype), requires_grad, None

    def new_tensor(self, values):
        return Tensor(values, self.values.dtype)

    def tolist(self):
        return self.values.tolist()


tensor = Tensor


def as_tensor(values, dtype):
    return values if isinstance(values, Tensor) else Tensor(values, dtype)


def stack(tensors):
    return Tensor([t.values for t in tensors])


class Function:
    @classmethod
    def apply(cls, *arguments):
        context = types.SimpleNamespace()
        result = cls.forward(context, *arguments)
        result.made_by = cls, context, arguments
        return result


def _grad(outputs, inputs, grad_outputs):
    function, context, arguments = outputs.made_by
    slopes = function.backward(context, grad_outputs)
    assert len(slopes) == len(arguments), "backward() returns a gradient for each argument of forward()"
    return tuple(slopes[[a is one for a in arguments].index(True)] for one in inputs)


autograd = types.SimpleNamespace(Function=Function, grad=_grad, function=types.SimpleNamespace(once_differentiable=lambda f: f))
