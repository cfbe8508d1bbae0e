#pragma once

namespace eerie::process {

/// From now on what cannot be written to standard error is dropped, without an error: a terminal
/// that was closed, a full disk or a reader that left is no reason to end a campaign. Call once,
/// before anything is written there.
void let_stderr_go_unread();

}  // namespace eerie::process
