#pragma once

#include <vector>

#include "analysis/diagrams/phase_diagram.hpp"
#include "campaign/auto_fidelity/auto_fidelity.hpp"

namespace eerie::auto_fidelity {

/// The maps of an automatic choice of fidelity, one per mass ratio and friction angle. Each cell
/// names the fidelity behind it, and has a heavy frame where it is in doubt.
std::vector<diagrams::PhaseDiagram> phase_diagrams(const AutoFidelity& campaign);

}  // namespace eerie::auto_fidelity
