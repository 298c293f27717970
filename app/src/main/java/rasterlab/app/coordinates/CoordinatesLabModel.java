package rasterlab.app.coordinates;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.work.Listeners;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.list.ListLabModel;
import rasterlab.app.coordinates.meeting.MeetingLabModel;
import rasterlab.app.coordinates.stack.StackLabModel;
import rasterlab.app.coordinates.turn.TurnLabModel;
import rasterlab.app.coordinates.view.ViewLabModel;
import rasterlab.app.mine.OwnMethods;

/** All labs of coordinates, and which of them is shown. */
public final class CoordinatesLabModel implements Kept<CoordinatesMode>, AutoCloseable {
    private final ViewLabModel views = new ViewLabModel();
    private final ListLabModel transformations;
    private final StackLabModel stack = new StackLabModel();
    private final TurnLabModel rotation;
    private final MeetingLabModel meeting = new MeetingLabModel();
    private final Listeners<CoordinatesMode> listeners = new Listeners<>();
    private CoordinatesMode mode = CoordinatesMode.VIEWS;

    /**
     * @param own the programs of the user's
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what background work threw, on any thread
     */
    public CoordinatesLabModel(OwnMethods own, Executor events, Consumer<Throwable> onFailure) {
        transformations = new ListLabModel(own, events, onFailure);
        rotation = new TurnLabModel(own, events, onFailure);
    }

    public ViewLabModel views() {
        return views;
    }

    public ListLabModel transformations() {
        return transformations;
    }

    public StackLabModel stack() {
        return stack;
    }

    public TurnLabModel rotation() {
        return rotation;
    }

    public MeetingLabModel meeting() {
        return meeting;
    }

    public CoordinatesMode mode() {
        return mode;
    }

    /** This, while it shows that mode. */
    Optional<CoordinatesLabModel> in(CoordinatesMode shown) {
        return mode == shown ? Optional.of(this) : Optional.empty();
    }

    public void show(CoordinatesMode next) {
        mode = next;
        listeners.tell(next);
    }

    /** Tells the listener each mode from now on; the answer ends that. */
    public Runnable listen(Consumer<CoordinatesMode> listener) {
        return listeners.add(listener);
    }

    @Override
    public Class<CoordinatesMode> keptType() {
        return CoordinatesMode.class;
    }

    @Override
    public CoordinatesMode kept() {
        return mode;
    }

    @Override
    public void restore(CoordinatesMode choice) {
        show(choice);
    }

    /** Ends the labs' threads. */
    @Override
    public void close() {
        transformations.close();
        rotation.close();
    }
}
