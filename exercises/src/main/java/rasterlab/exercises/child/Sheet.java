package rasterlab.exercises.child;

import java.io.DataOutputStream;
import java.io.IOException;

/**
 * What a student's method sends its items to keeps every one in order, up to a limit. It is the
 * same, and a fresh one, for every call, so that nothing tells a method whether it is timed: what
 * is timed is summed up afterwards.
 */
abstract class Sheet {
    /** Ends a method that goes on beyond the limit. */
    private static final class Full extends Error {
        private static final long serialVersionUID = 1L;

        Full() {
            super("too many items", null, false, false);
        }
    }

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

    /** Writes the number of items, then each as its contract's method has it. */
    abstract void writeTo(DataOutputStream out) throws IOException;

    /** Adds all items to a sum. */
    abstract void addTo(ItemSum sum);
}
