package rasterlab.exercises.runner;

import java.util.List;

/** What is put around a child's Java machine. */
interface Box {
    /** What to tell people about it. */
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
