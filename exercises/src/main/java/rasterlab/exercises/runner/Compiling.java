package rasterlab.exercises.runner;

import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.TimeLimit;

/** Makes class files of a source. */
@FunctionalInterface
interface Compiling {
    /**
     * @param children for one that needs a child to do so
     * @throws ChildLost when a child was killed from outside or could not work: our fault
     */
    Compilation compile(Children children, String source, TimeLimit limit)
            throws ChildLost, InterruptedException;

    /** Compiles in a fresh child, as hostile sources need. */
    static Compilation inAChild(Children children, String source, TimeLimit limit)
            throws ChildLost, InterruptedException {
        try (Child compiler = children.take(ChildKind.COMPILE)) {
            return Compilation.of(source, compiler, limit);
        }
    }
}
