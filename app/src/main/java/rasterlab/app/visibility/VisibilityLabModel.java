package rasterlab.app.visibility;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import rasterlab.app.canvas.History;
import rasterlab.app.canvas.Kept;
import rasterlab.app.canvas.LatestOnly;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.study.Method;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.Visibility;

/**
 * The hidden-surface lab without its window: what is drawn, how, from where.
 *
 * <p>Pictures are made on threads of the model's own; answers and commands all run on the thread of
 * the executor it is given. Each change publishes a new immutable {@link VisibilityLabState}.
 */
public final class VisibilityLabModel implements Kept<VisibilityChoice>, AutoCloseable {
    /** Makes a picture, or throws CancellationException once it is of no use any more. */
    @FunctionalInterface
    public interface PictureMaker {
        Raster picture(RenderRequest request, BooleanSupplier cancelled);
    }

    /** The scenes' own scale leaves room for every view; in the lab they may be larger. */
    private static final double FIRST_ZOOM = 1.6;

    private final Executor events;
    private final LatestOnly<RenderRequest, Picture> pictures;
    private final LatestOnly<RenderRequest, PictureDifference> differences;
    private final History<VisibilityChoice> history = new History<>();
    private final FrameTimes times = new FrameTimes();
    private final List<Consumer<VisibilityLabState>> listeners = new ArrayList<>();
    private final List<Method<Visibility>> methods = Renderer.visibilityMethods();
    private int width;
    private int height;
    private VisibilityLabState state;

    /**
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what a background picture threw, on any thread
     */
    public VisibilityLabModel(PictureMaker maker, Executor events, Consumer<Throwable> onFailure) {
        this.events = events;
        pictures =
                new LatestOnly<>(
                        "picture",
                        (request, cancelled) -> timed(maker, request, cancelled),
                        (request, picture) -> events.execute(() -> accept(picture)),
                        onFailure);
        differences =
                new LatestOnly<>(
                        "exact picture",
                        (request, cancelled) ->
                                PictureDifference.of(
                                        maker.picture(
                                                request.withVisibility(Renderer.REFERENCE),
                                                cancelled),
                                        maker.picture(request, cancelled)),
                        (request, found) -> events.execute(() -> accept(request, found)),
                        onFailure);
        state = new VisibilityLabState(first(), Optional.empty(), Optional.empty(), 0, false);
    }

    /** The vase by the painter, as its author shades it. */
    private static VisibilityChoice first() {
        Scene vase = Scenes.named("vase");
        return new VisibilityChoice(
                vase.name(),
                "painter",
                "tone",
                "perspective",
                vase.defaultCamera(),
                FIRST_ZOOM,
                false,
                false);
    }

    private static Picture timed(
            PictureMaker maker, RenderRequest request, BooleanSupplier cancelled) {
        long start = System.nanoTime();
        Raster raster = maker.picture(request, cancelled);
        return new Picture(request, raster, System.nanoTime() - start);
    }

    public VisibilityLabState state() {
        return state;
    }

    public List<Method<Visibility>> methods() {
        return methods;
    }

    /** Whether the chosen method can draw the faces' edges. */
    public boolean canDrawEdges() {
        return methods.stream()
                .filter(method -> method.name().equals(state.choice().visibility()))
                .anyMatch(method -> method.implementation().drawsOutlines());
    }

    /** Whether the picture of the present choice has edges. */
    public boolean drawsEdges() {
        return state.choice().edges() && canDrawEdges();
    }

    /** Tells the listener each new state from now on; the answer ends that. */
    public Runnable listen(Consumer<VisibilityLabState> listener) {
        listeners.add(listener);
        return () -> listeners.remove(listener);
    }

    /**
     * The size of the picture, in device pixels, from 1 to {@link Raster#LARGEST_SIDE}; before the
     * first call nothing is drawn.
     */
    public void resize(int newWidth, int newHeight) {
        if (newWidth == width && newHeight == height) return;
        Raster.checkSize(newWidth, newHeight);
        width = newWidth;
        height = newHeight;
        times.clear();
        draw(state.choice());
    }

    /**
     * Changes the choice and remembers the old one.
     *
     * @throws IllegalArgumentException if the engine does not know a chosen name
     */
    public void choose(UnaryOperator<VisibilityChoice> change) {
        VisibilityChoice next = change.apply(state.choice());
        if (next.equals(state.choice())) return;
        next.plain(1, 1); // Refuses unknown names before anything is remembered.
        history.remember(state.choice());
        draw(next);
    }

    /** Turns the eye by angles in radians; φ stays in [0, 2π) and so does θ. */
    public void turn(double dTheta, double dPhi) {
        choose(choice -> choice.withCamera(Cameras.turned(choice.camera(), dTheta, dPhi)));
    }

    /** Moves the eye away by a factor, within the distances that suit the scene. */
    public void retreat(double factor) {
        choose(
                choice ->
                        choice.withCamera(
                                Cameras.retreated(
                                        choice.camera(), factor, Scenes.named(choice.scene()))));
    }

    /** Brings the eye to a place. */
    public void look(SphericalView camera) {
        choose(choice -> choice.withCamera(camera));
    }

    public void beginDrag() {
        history.beginDrag(state.choice());
    }

    public void endDrag() {
        history.endDrag(state.choice());
        publish(state.choice(), state.picture(), state.difference());
    }

    public void undo() {
        history.undo().ifPresent(this::draw);
    }

    /** Back to the first scene, view and methods; can be undone. */
    public void reset() {
        choose(choice -> first());
    }

    @Override
    public Class<VisibilityChoice> keptType() {
        return VisibilityChoice.class;
    }

    @Override
    public VisibilityChoice kept() {
        return state.choice();
    }

    @Override
    public void bringBack(VisibilityChoice choice) {
        choice.plain(1, 1); // Refuses unknown names.
        draw(choice);
    }

    /** Waits until the pictures of every choice so far are made or dropped. Any other thread. */
    public void settle() throws InterruptedException {
        pictures.settle();
        differences.settle();
    }

    /** Ends the threads. */
    @Override
    public void close() {
        pictures.close();
        differences.close();
    }

    private void draw(VisibilityChoice choice) {
        VisibilityChoice old = state.choice();
        if (!choice.visibility().equals(old.visibility()) || !choice.scene().equals(old.scene()))
            times.clear();
        publish(choice, state.picture(), Optional.empty());
        differences.cancel();
        if (width == 0) return;
        RenderRequest plain = choice.plain(width, height);
        pictures.ask(drawsEdges() ? plain.withOutline() : plain);
        if (choice.difference()) differences.ask(plain);
    }

    private void accept(Picture picture) {
        if (picture.request().visibility().equals(state.choice().visibility()))
            times.add(picture.nanos());
        publish(state.choice(), Optional.of(picture), state.difference());
    }

    private void accept(RenderRequest request, PictureDifference found) {
        VisibilityChoice choice = state.choice();
        if (choice.difference() && same(request, choice.plain(width, height)))
            publish(choice, state.picture(), Optional.of(found));
    }

    /** Whether two requests ask for the same picture; scenes are compared by name. */
    private static boolean same(RenderRequest one, RenderRequest other) {
        return one.scene().name().equals(other.scene().name())
                && one.scene().pictureScale() == other.scene().pictureScale()
                && one.look().equals(other.look())
                && one.projection() == other.projection()
                && one.camera().equals(other.camera())
                && one.width() == other.width()
                && one.height() == other.height();
    }

    private void publish(
            VisibilityChoice choice,
            Optional<Picture> picture,
            Optional<PictureDifference> difference) {
        state =
                new VisibilityLabState(
                        choice, picture, difference, times.median(), !history.isEmpty());
        List.copyOf(listeners).forEach(listener -> listener.accept(state));
    }
}
