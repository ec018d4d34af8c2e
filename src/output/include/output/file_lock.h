#pragma once

namespace taut {

/// How long to wait where another process holds a lock: one that was just killed may not have let go yet.
enum class LockWait { none, a_while, for_ever };

/// Locks an open file for this process alone. It tells the running from the dead: the system takes the lock
/// away with the process that holds it, however it ended. False, with errno, where it can't be had: another
/// has it, or the file system knows no locks.
bool lock_file(int descriptor, LockWait wait);

}  // namespace taut
