package rasterlab.app.spline;

import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.work.Listeners;
import rasterlab.app.mine.OwnMethods;

/** Both labs of splines, and which of them is shown. */
public final class SplineLabModel implements Kept<SplineMode>, AutoCloseable {
    private final CurveLabModel curve;
    private final FunctionLabModel function;
    private final Listeners<SplineMode> listeners = new Listeners<>();
    private SplineMode mode = SplineMode.CURVE;

    /**
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what background work threw, on any thread
     */
    SplineLabModel(OwnMethods own, Executor events, Consumer<Throwable> onFailure) {
        curve = new CurveLabModel(own, events, onFailure);
        function = new FunctionLabModel(own, events, onFailure);
    }

    public CurveLabModel curve() {
        return curve;
    }

    public FunctionLabModel function() {
        return function;
    }

    public SplineMode mode() {
        return mode;
    }

    public void show(SplineMode next) {
        mode = next;
        listeners.tell(next);
    }

    /** Tells the listener each mode from now on; the answer ends that. */
    public Runnable listen(Consumer<SplineMode> listener) {
        return listeners.add(listener);
    }

    @Override
    public Class<SplineMode> keptType() {
        return SplineMode.class;
    }

    @Override
    public SplineMode kept() {
        return mode;
    }

    @Override
    public void restore(SplineMode choice) {
        show(choice);
    }

    /** Ends the labs' threads. */
    @Override
    public void close() {
        curve.close();
        function.close();
    }
}
