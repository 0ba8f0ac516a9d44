from .analysis.basin import basin
from .analysis.branches import continue_branch
from .analysis.comparison import compare
from .analysis.curves import continue_curves
from .analysis.first_passage import FirstPassage, strides_to_fall
from .analysis.rare_falls import RareFalls, rare_falls
from .analysis.stride_map import stride_map
from .analysis.sweeps import Sweep, gait_at, sweep
from .analysis.targeted import TargetNotMetError, find_gait
from .analysis.trajectories import trajectory
from .building.build import build
from .building.new import new
from .errors import GaitNotFoundError, InputError, RunError, TdmfSlipError
from .feedback.controllability import Controllability, controllability
from .feedback.gains import Feedback, dead_beat, lqr, place_poles
from .feedback.judgement import apex_covariance
from .fitting.fitted import fit
from .fitting.result import Fit
from .fmu.batch import simulate_many
from .fmu.fmu import Fmu, fmu_path, load_fmu
from .fmu.profile import Profile
from .fmu.simulation import simulate
from .library.batch import Batch
from .library.gait import Gait
from .library.ground import RoughGround
from .library.laws import AffineLaw
from .library.own_model import load_model
from .library.runner import Runner
from .optimization.optimize import optimize, pareto_front
from .optimization.optimum import Optimum
from .paper.validation import Validation, validate
from .pictures.plot import plot
from .proof.proof import Proof
from .proof.prove import prove
from .proof.prove_attraction import Attraction, prove_attraction
from .proof.prove_border import BorderProof, prove_border
from .version import __version__
from .viable_sets.viability import ViableController, viability

__all__ = [
    "AffineLaw",
    "Attraction",
    "Batch",
    "BorderProof",
    "Controllability",
    "Feedback",
    "FirstPassage",
    "Fit",
    "Fmu",
    "Gait",
    "GaitNotFoundError",
    "InputError",
    "Optimum",
    "Profile",
    "Proof",
    "RareFalls",
    "RoughGround",
    "RunError",
    "Runner",
    "Sweep",
    "TargetNotMetError",
    "TdmfSlipError",
    "Validation",
    "ViableController",
    "__version__",
    "apex_covariance",
    "basin",
    "build",
    "compare",
    "continue_branch",
    "continue_curves",
    "controllability",
    "dead_beat",
    "find_gait",
    "fit",
    "fmu_path",
    "gait_at",
    "load_fmu",
    "load_model",
    "lqr",
    "new",
    "optimize",
    "pareto_front",
    "place_poles",
    "plot",
    "prove",
    "prove_attraction",
    "prove_border",
    "rare_falls",
    "simulate",
    "simulate_many",
    "stride_map",
    "strides_to_fall",
    "sweep",
    "trajectory",
    "validate",
    "viability",
]
