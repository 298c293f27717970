package rasterlab.exercises.runner;

import java.util.List;
import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.Launcher;

/** The protection around a child's Java machine. */
interface Box {
    /** The message about it. */
    Isolation isolation();

    /** Whether the command's process starts another, in which the child's Java machine runs. */
    boolean nested();

    /**
     * Starts a child.
     *
     * @param warm whether the compiler tries itself out before the source comes
     * @throws java.io.UncheckedIOException when it cannot be started
     */
    default Child start(Launcher launcher, ChildKind kind, boolean warm) {
        return new Child(launcher.start(command(kind, warm)), nested());
    }

    /**
     * The whole command, program first.
     *
     * @param warm whether the compiler tries itself out before the source comes
     */
    List<String> command(ChildKind kind, boolean warm);
}
