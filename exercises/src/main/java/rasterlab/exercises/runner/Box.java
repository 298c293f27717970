package rasterlab.exercises.runner;

import java.util.List;

/** The protection around a child's Java machine. */
interface Box {
    /** The message about it. */
    Isolation isolation();

    /** Whether the command's process starts another, in which the child's Java machine runs. */
    boolean nested();

    /**
     * The whole command, program first.
     *
     * @param warm whether the compiler tries itself out before the source comes
     */
    List<String> command(ChildKind kind, boolean warm);
}
