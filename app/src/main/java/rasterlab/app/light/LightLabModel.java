package rasterlab.app.light;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.file.KeptFile;
import rasterlab.app.canvas.method.HazardNote;
import rasterlab.app.canvas.work.History;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.canvas.work.LatestReading;
import rasterlab.app.canvas.work.Listeners;
import rasterlab.app.light.step.OwnWalk;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.row.RowLabModel;
import rasterlab.engine.color.Colors;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.obj.UpAxis;
import rasterlab.engine.transform.SphericalView;

/**
 * The lighting lab without its window: what is lit, by which lamps, and a colour in all models.
 *
 * <p>Pictures are made on a thread of the model's own; answers and commands all run on the thread
 * of the executor it is given. Each change publishes a new immutable {@link LightLabState}.
 */
public final class LightLabModel implements Kept<LightLabModel.UndoableChoice>, AutoCloseable {
    private static final double NEAREST = 250;
    private static final double FARTHEST = 4000;
    private static final double STEEPEST = Math.PI - 0.05;

    /** The part of the state that undo brings back. */
    record UndoableChoice(
            LightChoice light,
            @JsonProperty("colours") boolean colors,
            @JsonProperty("colour") ColorChoice color) {}

    private final LatestOnly<LightFrame, LightFrame.DrawnFrame> pictures;
    private final LatestReading reader;
    private final PictureMaker maker;
    private final History<UndoableChoice> history = new History<>(this::chosen, this::show);
    private final Listeners<LightLabState> listeners = new Listeners<>();
    private final KeptFile<LitFile, LitBody, LitSceneOpening.LitSceneAnswer> keptFile;
    private final RowLabModel rows;
    private final OwnMethods own;
    private final OwnTrips ownTrips;
    public final LitPlans plans;
    public final OwnWalk walk = new OwnWalk(this::tellAll);
    private Optional<LitSceneFile> saved = Optional.empty();
    private int width;
    private int height;
    private LightLabState state =
            new LightLabState(
                    LightChoice.first(),
                    false,
                    Optional.empty(),
                    ColorChoice.first(),
                    "",
                    Optional.empty());

    /**
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what drawing threw, on any thread
     */
    public LightLabModel(Executor events, Consumer<Throwable> onFailure) {
        this(new OwnMethods(), events, onFailure);
    }

    public LightLabModel(OwnMethods own, Executor events, Consumer<Throwable> onFailure) {
        this(PictureMaker.by(new Renderer()), own, events, onFailure);
    }

    /**
     * @param maker closed with the model, when it draws no more
     */
    LightLabModel(
            PictureMaker maker, OwnMethods own, Executor events, Consumer<Throwable> onFailure) {
        this.maker = maker;
        this.own = own;
        rows = RowLabModel.ofTextures(own, events, onFailure);
        ownTrips = new OwnTrips(own, events, onFailure, this::tellAll);
        plans = new LitPlans(events, onFailure);
        var body = new MadeBody(own, plans);
        pictures =
                new LatestOnly<>(
                        "lit pictures",
                        (frame, cancelled) -> body.drawn(frame, maker, cancelled),
                        (frame, drawn) -> {
                            plans.shown(drawn);
                            events.execute(() -> accept(drawn));
                        },
                        onFailure);
        reader = new LatestReading("lit scene file", events, onFailure);
        keptFile = new KeptFile<>(new LitSceneOpening(this), reader);
    }

    /**
     * Opens a scene file or a model; what goes wrong, or is not shown of it, is told in the state.
     */
    public void open(Path file) {
        keptFile.open(LitSceneOpening.reading(file, state.choice()));
    }

    /** Stands the lit model on another axis; its file is read again, and it can be undone. */
    public void stand(UpAxis up) {
        if (state.choice().body().up().filter(now -> now != up).isPresent())
            keptFile.open(LitSceneOpening.standing(state.choice(), up));
    }

    /** Says why a file was not opened, or what of it is not shown. */
    void tellProblem(String problem) {
        publish(state.choice(), state.drawn(), problem);
    }

    /** Forgets what could not be shown, also where the same is chosen: the user has gone on. */
    private void forgetProblem() {
        if (!state.problem().isEmpty()) tellProblem("");
    }

    /** Lights a scene of the user's. */
    void open(LightChoice light) {
        history.remember();
        show(new UndoableChoice(light, false, state.color()));
    }

    /** Lights a body that an earlier run has shown; there is nothing to undo afterwards. */
    void restore(LitBody body) {
        history.forget();
        show(new UndoableChoice(state.choice().with(body), state.colors(), state.color()));
    }

    /** Whether the user has brought a program that may light the scene. */
    public boolean hasOwnLight() {
        return own.of(LightOfPoints.TOPIC).isPresent() || own.of(LightOfFaces.TOPIC).isPresent();
    }

    /**
     * Lights by the user's program on a topic, which may be another by now.
     *
     * @param input another one than is shown
     * @param beside the method that its input is shown by
     */
    public void showOwn(String topic, Optional<Object> input, String beside) {
        rows.close();
        showColors(false);
        input.ifPresent(one -> show(topic, "", one, beside));
        choose(choice -> choice.byOwn(topic));
        walk.reset();
        if (width > 0) pictures.ask(new LightFrame(state.choice(), width, height));
    }

    /** The file that the scene was saved into last. */
    public Optional<LitSceneFile> saved() {
        return saved;
    }

    public void keep(LitSceneFile file) {
        saved = Optional.of(file);
        publish(state.choice(), state.drawn(), "");
    }

    /** The tab's third lab: rows of textures. */
    public RowLabModel rows() {
        return rows;
    }

    public LightLabState state() {
        return state;
    }

    /** Tells the listener each new state from now on; the answer ends that. */
    public Runnable listen(Consumer<LightLabState> listener) {
        return listeners.add(listener);
    }

    /**
     * Sets the size of each of the three pictures, in device pixels, from 1 to {@link
     * Raster#LARGEST_SIDE}; before the first call nothing is drawn.
     */
    public void resize(int newWidth, int newHeight) {
        if (newWidth == width && newHeight == height) return;
        Raster.checkSize(newWidth, newHeight);
        width = newWidth;
        height = newHeight;
        pictures.ask(new LightFrame(state.choice(), width, height));
    }

    /** Changes the light and remembers how it was. */
    public void choose(UnaryOperator<LightChoice> change) {
        LightChoice next = change.apply(state.choice());
        if (next.equals(state.choice())) {
            forgetProblem();
            return;
        }
        history.remember();
        show(new UndoableChoice(next, state.colors(), state.color()));
    }

    /** Changes the colour and remembers how it was. */
    public void color(UnaryOperator<ColorChoice> change) {
        ColorChoice next = change.apply(state.color());
        if (next.equals(state.color())) return;
        history.remember();
        show(new UndoableChoice(state.choice(), state.colors(), next));
    }

    /** How a colour comes back by the user's program; empty until that is found. */
    public Optional<OwnTrips.Trips> ownTrips(ColorChoice color) {
        return ownTrips.of(color);
    }

    /** Shows colour models and asks the user's program, which may be another by now, once more. */
    public void enterColors() {
        rows.close();
        ownTrips.forget();
        showColors(true);
    }

    /** Shows colour models instead of light, or light again. */
    public void showColors(boolean shown) {
        if (shown == state.colors()) return;
        history.remember();
        show(new UndoableChoice(state.choice(), shown, state.color()));
    }

    /** Says beside the present picture in what it is other than a hazard. */
    public void tell(HazardNote note) {
        state =
                new LightLabState(
                        state.choice(),
                        state.colors(),
                        state.drawn(),
                        state.color(),
                        state.problem(),
                        Optional.of(note));
        tellAll();
    }

    /**
     * Shows a hazard, of several colours or points the first.
     *
     * @param input the hazard's
     * @param method by which, where the lab has it
     */
    public void show(String topic, String hazard, Object input, String method) {
        boolean colors = input instanceof Colors;
        ColorChoice color = state.color();
        LightChoice light = state.choice();
        boolean mine = method.equals(OwnMethods.NAME);
        if (input instanceof Colors several) color = color.with(several, method);
        else
            light =
                    TopicBodies.shown(
                            TopicBodies.body(topic, hazard, input), input, mine ? "" : method);
        if (mine && !colors) light = light.byOwn(topic);
        var next = new UndoableChoice(light, colors, color);
        if (next.equals(chosen())) return;
        history.remember();
        show(next);
    }

    /** Draws the normals of faces and corners, or no more. */
    public void drawNormals(boolean drawn) {
        choose(choice -> choice.withArrows(drawn));
    }

    /** Turns the eye by angles in radians; it stays above one pole and below the other. */
    public void turn(double dTheta, double dPhi) {
        choose(
                choice -> {
                    SphericalView eye = choice.camera();
                    double phi = Math.max(0.05, Math.min(STEEPEST, eye.phiRadians() + dPhi));
                    double theta = (eye.thetaRadians() + dTheta) % (2 * Math.PI);
                    return choice.with(new SphericalView(theta, phi, eye.rho()));
                });
    }

    /** Moves the eye away by a factor. */
    public void dolly(double factor) {
        choose(
                choice -> {
                    SphericalView eye = choice.camera();
                    double rho = Math.max(NEAREST, Math.min(FARTHEST, eye.rho() * factor));
                    return choice.with(
                            new SphericalView(eye.thetaRadians(), eye.phiRadians(), rho));
                });
    }

    public void beginDrag() {
        history.beginDrag();
        plans.beginDrag();
    }

    public void endDrag() {
        history.endDrag();
        plans.endDrag();
        publish(state.choice(), state.drawn(), state.problem());
    }

    /** The choices that can be undone and redone. */
    public History<UndoableChoice> history() {
        return history;
    }

    /** Returns to the first light and colour; can be undone. */
    public void reset() {
        var first = new UndoableChoice(LightChoice.first(), state.colors(), ColorChoice.first());
        if (first.equals(chosen())) {
            forgetProblem();
            return;
        }
        history.remember();
        show(first);
    }

    @Override
    public Class<UndoableChoice> keptType() {
        return UndoableChoice.class;
    }

    @Override
    public UndoableChoice kept() {
        LitBody body = state.choice().body();
        LightChoice light =
                body.opened().isEmpty()
                        ? state.choice()
                        : state.choice().with(LightChoice.first().body());
        return new UndoableChoice(light, state.colors(), state.color());
    }

    @Override
    public void restore(UndoableChoice choice) {
        show(choice);
    }

    /** Whose body is shown; brought back after the choice itself. */
    public Kept<LitFile> keptFile() {
        return keptFile;
    }

    /** Waits until the pictures of every choice so far are made or dropped. Any other thread. */
    public void settle() throws InterruptedException {
        reader.settle();
        pictures.settle();
        rows.settle();
        ownTrips.settle();
        plans.settle();
    }

    /** Ends the threads; the one that draws closes what it draws by. */
    @Override
    public void close() {
        reader.close();
        pictures.close(maker::close);
        rows.end();
        ownTrips.close();
        plans.close();
    }

    private UndoableChoice chosen() {
        return new UndoableChoice(state.choice(), state.colors(), state.color());
    }

    private void show(UndoableChoice next) {
        boolean other = !next.light().equals(state.choice());
        state =
                new LightLabState(
                        next.light(),
                        next.colors(),
                        state.drawn(),
                        next.color(),
                        "",
                        Optional.empty());
        publish(next.light(), state.drawn(), "");
        if (other && width > 0) pictures.ask(new LightFrame(next.light(), width, height));
    }

    private void accept(LightFrame.DrawnFrame drawn) {
        publish(state.choice(), Optional.of(drawn), state.problem());
        plans.accept(drawn);
    }

    private void publish(
            LightChoice choice, Optional<LightFrame.DrawnFrame> drawn, String problem) {
        state =
                new LightLabState(
                        choice, state.colors(), drawn, state.color(), problem, state.note());
        tellAll();
    }

    private void tellAll() {
        listeners.tell(state);
    }
}
