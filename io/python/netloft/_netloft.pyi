# SPDX-License-Identifier: BSD-3-Clause
# The compiled module for editors and type checkers: the classes that callables of a user meet. The rest is internal.
from typing import Any

from numpy.typing import ArrayLike, NDArray

__version__: str

def __getattr__(name: str) -> Any: ...

class Problem:
    """The equations r(u) = 0 as a solver sees them; valid until the solver returns."""

    @property
    def size(self) -> int:
        """The number of unknowns."""
    @property
    def u(self) -> NDArray[Any]:
        """A copy of the displacements to start from [m]."""
    def evaluate(self, u: ArrayLike, tangent: bool = False) -> tuple[float, NDArray[Any]]:
        """Energy [J] and residual [N]; with `tangent` K, too, for factorise(). Raises ValueError where forces are not defined."""
    def factorise(self, shift: float = 0.0, indefinite: bool = False) -> bool:
        """Factorises K of the last evaluate(u, tangent=True), plus shift times the linear stiffness; it must be positive definite
        unless `indefinite`. False: there is no such factor."""
    def solve(self, rhs: ArrayLike) -> NDArray[Any]:
        """The solution by the last factor."""
    def multiply(self, x: ArrayLike, shift: float = 0.0) -> NDArray[Any]:
        """K plus shift times the linear stiffness, times x."""
    def progress(self, u: ArrayLike, energy: float, residual: ArrayLike) -> bool:
        """Counts an iteration that ended at u; False: the search is over."""

class Search:
    """A scene and its easier variants as a strategy sees them; valid until the strategy returns."""

    @property
    def start(self) -> NDArray[Any]:
        """The displacements to start from [m]."""
    @property
    def levels(self) -> int:
        """The number of meshes; level 0 is that of the scene, the others are coarser."""
    @property
    def conservative(self) -> bool:
        """Whether the forces have an energy."""
    @property
    def gear_size(self) -> float:
        """The length of the gear [m]."""
    @property
    def stiffness(self) -> float:
        """The largest axial stiffness [N]."""
    @property
    def load(self) -> float:
        """The sum of the forces that drive the gear at the start [N]."""
    @property
    def work_left(self) -> float:
        """The work that may still be spent."""
    def solve(self, u: ArrayLike, *, name: str = ..., solver: str = ..., level: int = ..., stiffness_cap: float = ...,
              compression: float = ..., current: float = ..., tolerance: float = ..., work: float = ..., iterations: int = ...) -> dict[str, Any]:
        """Solves the scene, or an easier variant of it: u, ending, residual, load, energy, spent, iterations, factorisations, growing."""
    def transfer(self, from_level: int, u: ArrayLike, to_level: int) -> NDArray[Any]:
        """Displacements on another mesh."""
    def answer(self, u: ArrayLike) -> None:
        """Reports an equilibrium of the scene itself, which Netloft judges."""
