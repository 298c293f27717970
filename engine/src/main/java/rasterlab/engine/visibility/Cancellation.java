package rasterlab.engine.visibility;

import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/** How a method stops when its caller no longer wants the picture. */
public final class Cancellation {
    private Cancellation() {}

    /**
     * @throws CancellationException if {@code cancelled} says true
     */
    public static void check(BooleanSupplier cancelled) {
        if (cancelled.getAsBoolean()) throw new CancellationException("the picture is cancelled");
    }
}
