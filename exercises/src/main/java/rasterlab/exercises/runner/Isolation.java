package rasterlab.exercises.runner;

/**
 * What shuts the student's method in on this machine.
 *
 * @param name "bubblewrap" or "process limits only", as stored with a report
 * @param describe one honest line for start-up, log and result page
 * @param exam whether it is meant to hold against a determined attacker, so that exams may be
 *     graded
 */
public record Isolation(String name, String describe, boolean exam) {
    /** Namespaces, an empty read-only root, no network, no other processes. */
    static Isolation bubblewrap(String version) {
        return new Isolation(
                "bubblewrap",
                version
                        + ": own process, network and file namespaces, read-only root with nothing but the JDK, limits on heap, time and output",
                true);
    }

    /**
     * Separate processes and their limits, nothing of the operating system's.
     *
     * @param reason why bubblewrap is not used, such as "bwrap is not on the PATH"
     */
    static Isolation processLimits(String reason) {
        return new Isolation(
                "process limits only",
                "protected against mistakes and common tricks, not against a determined attacker; use your own students only, or the Linux server ("
                        + reason
                        + ")",
                false);
    }
}
