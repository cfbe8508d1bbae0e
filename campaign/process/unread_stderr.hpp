#pragma once

namespace eerie::process {

/// From now on output that standard error cannot take is dropped without an error. A closed
/// terminal, a full disk or a missing reader is no reason to end a campaign. Call it once, before
/// anything is written there.
void let_stderr_go_unread();

}  // namespace eerie::process
