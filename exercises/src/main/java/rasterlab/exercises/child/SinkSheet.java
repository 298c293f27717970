package rasterlab.exercises.child;

import java.io.DataOutputStream;
import java.io.IOException;
import java.util.stream.Stream;

/**
 * Keeps every item that a student's method sends, in order, up to a limit. Each call gets a fresh
 * one of the same class, so that nothing tells a method whether it is timed: timed items are summed
 * up afterwards.
 */
abstract class SinkSheet {
    /** Ends a method that goes on beyond the limit. */
    private static final class Full extends Error {
        private static final long serialVersionUID = 1L;

        Full() {
            super("too many items", null, false, false);
        }
    }

    /** Items that there is room for from the start where nothing else is said. */
    static final int USUAL = 256;

    private boolean full;

    /** Throws once; a method that swallows that and goes on ends the process. */
    final void stop() {
        if (full) Runtime.getRuntime().halt(Wire.EXIT_OUTPUT);
        full = true;
        throw new Full();
    }

    boolean full() {
        return full;
    }

    /** Whether one of the arguments of a call is a sheet that is full. */
    static boolean isAnyFull(Object[] arguments) {
        return Stream.of(arguments).anyMatch(one -> one instanceof SinkSheet sheet && sheet.full());
    }

    /** Writes the number of items, then each as its contract's method has it. */
    abstract void writeTo(DataOutputStream out) throws IOException;

    /** Adds all items to a sum. */
    abstract void addTo(ItemSum sum);
}
