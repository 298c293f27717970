package rasterlab.app.visibility;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.plan.least.PlanDrawing;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.plan.Plan;

/** Finds pictures and what is told of them, each on a thread of its own. */
final class StageWork implements AutoCloseable {
    private final PictureMaker maker;
    private final PlanDrawing plans = new PlanDrawing();
    private final LatestOnly<Frame, Frame.FramePictures> pictures;
    private final LatestOnly<Frame, Differences> differences;
    private final LatestOnly<RenderRequest, Optional<Drawn>> walks;
    private final LatestOnly<PixelReport.PixelRequest, PixelReport> histories;

    /**
     * Receives what was found.
     *
     * @param pictures the newest ones
     * @param differences of a frame
     * @param walks steps of a request
     * @param histories what happened at a pixel
     */
    record StageListeners(
            Consumer<Frame.FramePictures> pictures,
            BiConsumer<Frame, Differences> differences,
            BiConsumer<RenderRequest, Optional<Drawn>> walks,
            Consumer<PixelReport> histories) {}

    /**
     * @param maker closed when nothing is drawn any more
     * @param events runs what it is given on the one thread that is told, in order
     * @param onFailure told what a background picture threw, on any thread
     */
    StageWork(
            PictureMaker maker,
            Executor events,
            Consumer<Throwable> onFailure,
            StageListeners told) {
        this.maker = maker;
        pictures =
                new LatestOnly<>(
                        "picture",
                        (frame, cancelled) -> frame.made(maker, plans, cancelled),
                        (frame, made) -> {
                            made.first().planned().ifPresent(plans::shown);
                            events.execute(() -> told.pictures().accept(made));
                        },
                        onFailure);
        differences =
                new LatestOnly<>(
                        "exact picture",
                        (frame, cancelled) -> Differences.of(frame, maker, cancelled),
                        (frame, found) ->
                                events.execute(() -> told.differences().accept(frame, found)),
                        onFailure);
        walks =
                new LatestOnly<>(
                        "steps",
                        Drawn::of,
                        (request, found) ->
                                events.execute(() -> told.walks().accept(request, found)),
                        onFailure);
        histories =
                new LatestOnly<>(
                        "pixel history",
                        PixelReport::of,
                        (asked, found) -> events.execute(() -> told.histories().accept(found)),
                        onFailure);
    }

    void draw(Frame frame) {
        pictures.ask(frame);
    }

    /** Draws by that plan no more. */
    void refute(Plan plan) {
        plans.refute(plan);
    }

    void compare(Frame frame) {
        differences.ask(frame);
    }

    void walk(RenderRequest request) {
        walks.ask(request);
    }

    void report(PixelReport.PixelRequest question) {
        histories.ask(question);
    }

    /** Drops what is being told of the pictures before. */
    void cancelTelling() {
        differences.cancel();
        histories.cancel();
    }

    /** Waits until all that was asked so far is found or dropped. Any other thread. */
    void settle() throws InterruptedException {
        walks.settle();
        pictures.settle();
        differences.settle();
        histories.settle();
    }

    /** Ends the threads; the last of the two that draw closes what they draw by. */
    @Override
    public void close() {
        var drawing = new AtomicInteger(2);
        Runnable after =
                () -> {
                    if (drawing.decrementAndGet() == 0) maker.close();
                };
        pictures.close(after);
        differences.close(after);
        walks.close();
        histories.close();
    }
}
