package rasterlab.app.visibility;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.chart.ChartSize;
import rasterlab.app.language.Language;
import rasterlab.app.precision.DepthPrecisionChart;
import rasterlab.app.visibility.scene.StageView;

/**
 * Charts counted in the background, with progress; what was counted is kept.
 *
 * <p>Used on one thread, that of the executor it is given.
 */
final class ChartStudies implements AutoCloseable {
    /** A chart in a language and size, on a stage in those colours. */
    record ChartRequest(StageView view, Language language, StageColors colors, ChartSize size) {
        /** Whether a chart of the one serves for the other until that is made. */
        boolean isLike(ChartRequest other) {
            return other.equals(new ChartRequest(view, language, colors, other.size));
        }
    }

    /** A finished chart. */
    record FinishedChart(ChartRequest asked, BufferedImage image, Supplier<byte[]> svg) {}

    private final Executor events;
    private final LatestOnly<ChartRequest, FinishedChart> work;
    private final List<Runnable> listeners = new ArrayList<>();
    private Optional<GrowthChart> growth = Optional.empty();
    private Optional<ChartRequest> asked = Optional.empty();
    private Optional<FinishedChart> chart = Optional.empty();
    private double progress;

    ChartStudies(Executor events, Consumer<Throwable> onFailure) {
        this.events = events;
        work =
                new LatestOnly<>(
                        "chart",
                        this::made,
                        (question, found) -> events.execute(() -> accept(found)),
                        onFailure);
    }

    /** Asks for a chart unless it is there or on its way. */
    void ask(ChartRequest question) {
        if (asked.equals(Optional.of(question))) return;
        asked = Optional.of(question);
        chart = chart.filter(old -> old.asked().isLike(question));
        progress = 0;
        work.ask(question);
    }

    /** Gives the chart up that is being made. */
    void cancel() {
        asked = chart.map(FinishedChart::asked);
        work.cancel();
    }

    /** The chart asked for last; empty while it is made. */
    Optional<FinishedChart> chart() {
        return chart;
    }

    /** The share of the work that is done, 0 to 1. */
    double progress() {
        return progress;
    }

    /** Calls the listener when there is more to show, from now on; what is returned ends that. */
    Runnable listen(Runnable listener) {
        listeners.add(listener);
        return () -> listeners.remove(listener);
    }

    void settle() throws InterruptedException {
        work.settle();
    }

    @Override
    public void close() {
        work.close();
    }

    private FinishedChart made(ChartRequest question, BooleanSupplier cancelled) {
        var paper = ChartLook.on(question.colors());
        Language language = question.language();
        if (question.view() == StageView.PRECISION)
            return new FinishedChart(
                    question,
                    DepthPrecisionChart.image(language, paper, question.size()),
                    () -> DepthPrecisionChart.svg(language, paper));
        GrowthChart counted = counted(cancelled);
        return new FinishedChart(
                question,
                counted.image(language, paper, question.size()),
                () -> counted.svg(language, paper));
    }

    /** Only the worker's thread comes here. */
    private GrowthChart counted(BooleanSupplier cancelled) {
        if (growth.isEmpty())
            growth =
                    Optional.of(
                            GrowthChart.counted(
                                    share -> events.execute(() -> accept(share)), cancelled));
        return growth.get();
    }

    private void accept(double share) {
        progress = share;
        tell();
    }

    private void accept(FinishedChart found) {
        if (!asked.equals(Optional.of(found.asked()))) return;
        chart = Optional.of(found);
        tell();
    }

    private void tell() {
        List.copyOf(listeners).forEach(Runnable::run);
    }
}
