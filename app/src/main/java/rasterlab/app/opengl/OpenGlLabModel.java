package rasterlab.app.opengl;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.file.KeptFile;
import rasterlab.app.canvas.work.History;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.canvas.work.LatestReading;
import rasterlab.app.canvas.work.Listeners;
import rasterlab.app.opengl.OpenGlLabState.OpenGlPictures;
import rasterlab.app.opengl.call.FrameCalls;
import rasterlab.app.opengl.call.GlCall;
import rasterlab.app.opengl.context.GlReport;
import rasterlab.app.opengl.context.NoOpenGl;
import rasterlab.app.opengl.software.SoftwarePainter;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.GlFrame;
import rasterlab.app.opengl.state.LabImages;
import rasterlab.app.opengl.state.Setting;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.texture.Texture;

/**
 * The OpenGL lab without its window: the state that is chosen, and its two pictures.
 *
 * <p>OpenGL's picture comes from the window that {@link #attach} announces, or, as long as there is
 * none, from a context without a window; so does the very first one, which loads the libraries and
 * the driver on the way. Answers and commands all run on the thread of the executor it is given;
 * pictures are made on a thread of the model's own.
 */
public final class OpenGlLabModel implements Kept<GlChoice>, AutoCloseable {
    private final Executor events;
    private final LatestOnly<Question, Answer> pictures;
    private final LatestReading reader;
    private final KeptFile<KeptImage, GlChoice, ImageLoading> keptImage;
    private final History<GlChoice> history =
            new History<>(() -> state().choice(), choice -> draw(choice, state().touched()));
    private final Listeners<OpenGlLabState> listeners = new Listeners<>();
    private final LabImages images = new LabImages();
    private final OffscreenGl offscreen = new OffscreenGl();
    private Optional<SoftwarePainter> painter = Optional.empty();
    private int windows;
    private int width;
    private int height;
    private OpenGlLabState state;

    /**
     * @param openGl the picture that OpenGL's window has drawn already; empty where the model draws
     */
    private record Question(GlFrame frame, Optional<Raster> openGl) {}

    /**
     * @param report set where the model has drawn OpenGL's picture itself
     * @param missing why it could not
     */
    private record Answer(
            OpenGlPictures pictures, Optional<GlReport> report, Optional<String> missing) {}

    /**
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what background work threw, on any thread
     */
    public OpenGlLabModel(Executor events, Consumer<Throwable> onFailure) {
        this.events = events;
        pictures =
                new LatestOnly<>(
                        "opengl and software",
                        this::answer,
                        (question, answer) -> events.execute(() -> accept(question, answer)),
                        onFailure);
        reader = new LatestReading("image", events, onFailure);
        keptImage = new KeptFile<>(new ImageOpening(this), reader);
        state =
                new OpenGlLabState(
                        GlChoice.first(),
                        List.of(),
                        OpenGlPictures.NONE,
                        Optional.empty(),
                        Optional.empty(),
                        Optional.empty(),
                        Setting.SCENE);
    }

    private int textureLimit() {
        return state.report().map(GlReport::textureSide).orElse(Texture.LARGEST);
    }

    private Answer answer(Question question, BooleanSupplier cancelled) {
        Raster software = painter().draw(question.frame(), cancelled);
        if (question.openGl().isPresent())
            return new Answer(
                    compared(question.openGl().get(), software),
                    Optional.empty(),
                    Optional.empty());
        try {
            OffscreenGl.OffscreenPicture drawn = offscreen.draw(question.frame());
            return new Answer(
                    compared(drawn.picture(), software),
                    Optional.of(drawn.report()),
                    Optional.empty());
        } catch (NoOpenGl e) {
            var alone =
                    new OpenGlPictures(Optional.empty(), Optional.of(software), Optional.empty());
            return new Answer(alone, Optional.empty(), Optional.of(e.getMessage()));
        }
    }

    private static OpenGlPictures compared(Raster openGl, Raster software) {
        return new OpenGlPictures(
                Optional.of(openGl),
                Optional.of(software),
                Optional.of(Comparison.of(openGl, software)));
    }

    /** The painter, used on the thread that draws. */
    private SoftwarePainter painter() {
        if (painter.isEmpty()) painter = Optional.of(new SoftwarePainter());
        return painter.get();
    }

    public OpenGlLabState state() {
        return state;
    }

    /** The frame of the present choice; empty before there is a size. */
    public Optional<GlFrame> frame() {
        if (width == 0) return Optional.empty();
        return Optional.of(new GlFrame(state.choice(), width, height, images.of(state.choice())));
    }

    /** Tells the listener each new state from now on; the answer ends that. */
    public Runnable listen(Consumer<OpenGlLabState> listener) {
        return listeners.add(listener);
    }

    /**
     * A window of OpenGL will draw each new choice, once the model has made a first picture without
     * it, and bring its picture to {@link #drawn}, until {@link #detach}.
     */
    public void attach() {
        windows++;
    }

    /** The window is gone, or cannot draw: the model draws OpenGL's picture again. */
    public void detach() {
        windows--;
        ask();
    }

    /** Takes OpenGL's picture of a frame from its window. */
    public void drawn(GlFrame frame, Raster picture, GlReport report) {
        publish(state.choice(), state.pictures(), Optional.of(report), Optional.empty());
        pictures.ask(new Question(frame, Optional.of(picture)));
    }

    /** Sets the size of each picture in device pixels; before the first call nothing is drawn. */
    public void resize(int newWidth, int newHeight) {
        if (newWidth == width && newHeight == height) return;
        Raster.checkSize(newWidth, newHeight);
        width = newWidth;
        height = newHeight;
        state = with(state.choice(), state.problem(), state.touched());
        tell();
        ask();
    }

    /**
     * Changes one setting.
     *
     * @throws IllegalArgumentException for an option that the setting does not have
     */
    public void set(Setting setting, String option) {
        change(state.choice().with(setting, option), setting);
    }

    /** Changes the view, as a drag does. */
    public void move(UnaryOperator<GlChoice> change) {
        change(change.apply(state.choice()), state.touched());
    }

    /** Brings the view of a chip. */
    public void show(GlView view) {
        change(view.choice(), state.touched());
    }

    private void change(GlChoice next, Setting touched) {
        if (next.equals(state.choice())) {
            if (state.problem().isPresent()) tellProblem(Optional.empty());
            touch(touched);
            return;
        }
        history.remember();
        draw(next, touched);
    }

    /** Points at a setting, whose calls are then shown. */
    public void touch(Setting setting) {
        if (setting == state.touched()) return;
        state = with(state.choice(), state.problem(), setting);
        tell();
    }

    /** Makes an image file the texture; what is wrong with it is in the state then. */
    public void open(Path file) {
        keptImage.open(reading(file));
    }

    Supplier<ImageLoading> reading(Path file) {
        int limit = textureLimit();
        return () -> ImageLoading.of(file, limit);
    }

    /** Makes the user's image the texture. */
    void open(GlChoice.ImageTexture image) {
        change(state.choice().withFile(image), Setting.IMAGE);
    }

    /** Makes an image of an earlier run the texture; there is nothing to undo afterwards. */
    void restore(GlChoice.ImageTexture image, boolean shown) {
        history.forget();
        draw(state.choice().withFile(image, shown), state.touched());
    }

    /** Says what is wrong with the user's image; empty for nothing. */
    void tellProblem(Optional<String> problem) {
        state = with(state.choice(), problem, state.touched());
        tell();
    }

    public void beginDrag() {
        history.beginDrag();
    }

    public void endDrag() {
        history.endDrag();
        state = with(state.choice(), state.problem(), state.touched());
        tell();
    }

    /** The choices that can be undone and redone. */
    public History<GlChoice> history() {
        return history;
    }

    /** Returns to how the lab opens; can be undone. */
    public void reset() {
        change(GlChoice.first(), Setting.SCENE);
    }

    @Override
    public Class<GlChoice> keptType() {
        return GlChoice.class;
    }

    /** The choice without an image file, which may be gone by the next run. */
    @Override
    public GlChoice kept() {
        return state.choice().withoutFile();
    }

    @Override
    public void restore(GlChoice choice) {
        draw(choice, Setting.SCENE);
    }

    /** The user's image; brought back after the choice itself. */
    public Kept<KeptImage> keptImage() {
        return keptImage;
    }

    /** Waits until the pictures of every choice so far are made or dropped. Any other thread. */
    public void settle() throws InterruptedException {
        reader.settle();
        pictures.settle();
    }

    /** Ends the threads; the one that draws gives OpenGL's objects back when it is done. */
    @Override
    public void close() {
        reader.close();
        pictures.close(
                () -> {
                    offscreen.close();
                    painter.ifPresent(SoftwarePainter::close);
                });
    }

    private void draw(GlChoice choice, Setting touched) {
        state = with(choice, Optional.empty(), touched);
        tell();
        ask();
    }

    private void ask() {
        if (windows > 0 && state.pictures().software().isPresent()) return;
        frame().ifPresent(frame -> pictures.ask(new Question(frame, Optional.empty())));
    }

    private void accept(Question question, Answer answer) {
        Optional<GlReport> report = answer.report().or(state::report);
        // OpenGL may work in a window where it does not work without one.
        Optional<String> missing = answer.missing().filter(reason -> windows == 0);
        publish(
                state.choice(),
                answer.pictures(),
                missing.isPresent() ? Optional.empty() : report,
                missing);
    }

    private OpenGlLabState with(GlChoice choice, Optional<String> problem, Setting touched) {
        List<GlCall> calls = List.of();
        if (width > 0) calls = FrameCalls.of(new GlFrame(choice, width, height, images.of(choice)));
        return new OpenGlLabState(
                choice, calls, state.pictures(), state.report(), state.missing(), problem, touched);
    }

    private void publish(
            GlChoice choice,
            OpenGlPictures shown,
            Optional<GlReport> report,
            Optional<String> missing) {
        state =
                new OpenGlLabState(
                        choice,
                        state.calls(),
                        shown,
                        report,
                        missing,
                        state.problem(),
                        state.touched());
        tell();
    }

    private void tell() {
        listeners.tell(state);
    }
}
