package rasterlab.engine.fill;

import java.util.List;
import java.util.Map;
import rasterlab.contract.SeedFiller;
import rasterlab.engine.raster.CountingPixels;
import rasterlab.engine.raster.PixelPredicate;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.SampledPixels;
import rasterlab.engine.raster.SetComparison;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/**
 * Filling a region from a seed; an output is the pixels written, in their order.
 *
 * <p>A fill that leaves pixels out or writes others, in whatever colour, is wrong; one that writes
 * pixels of the region again is degraded: its picture is right. A pixel of the region that is given
 * another colour than the new one is not filled.
 */
public final class FillTopic implements Topic<SeedFiller, FillTask, PixelRecording> {
    private static final int MOST_ITEMS = 1_000_000;

    /** Rows that are kept one below the other where not all are, to see what goes wrong between. */
    private static final int ROWS_TOGETHER = 8;

    @Override
    public String name() {
        return "fill";
    }

    @Override
    public String lab() {
        return "polygon";
    }

    @Override
    public Class<SeedFiller> contract() {
        return SeedFiller.class;
    }

    @Override
    public List<Method<SeedFiller>> methods() {
        return FillMethods.all();
    }

    @Override
    public List<Hazard<FillTask>> hazards() {
        return FillHazards.all();
    }

    @Override
    public List<Workload<FillTask>> workloads() {
        return FillWorkloads.all();
    }

    @Override
    public List<Mutant<SeedFiller>> mutants() {
        return FillMutants.all();
    }

    @Override
    public List<Slip<SeedFiller>> slips(SeedFiller right) {
        return FillSlips.of(right);
    }

    @Override
    public PixelRecording run(SeedFiller method, FillTask task, int limit) {
        var recording = new PixelRecording(limit);
        var picture = new FilledPicture(new TextPicture(task.rows()), task, recording);
        method.fill(picture, task.x(), task.y(), task.with(), task.connectivity());
        return recording;
    }

    /** {@inheritDoc} Methods fill in different orders, so the part is made of whole rows. */
    @Override
    public PixelRecording recordPart(SeedFiller method, FillTask task, int limit) {
        if (rowStep(task) == 1) return record(method, task, limit);
        var text = new TextPicture(task.rows());
        long pixels = (long) text.width() * text.height();
        var sample = new SampledPixels(part(task), 2 * pixels, limit);
        method.fill(
                new FilledPicture(text, task, sample),
                task.x(),
                task.y(),
                task.with(),
                task.connectivity());
        return sample.recording();
    }

    @Override
    public PixelRecording exactPart(FillTask task, int limit) {
        if (rowStep(task) == 1) return exact(task, limit);
        PixelPredicate part = part(task);
        var recording = new PixelRecording(limit);
        new ExactSeedFill(task)
                .fill(
                        (x, y) -> {
                            if (part.test(x, y) && recording.size() < limit) recording.plot(x, y);
                        });
        return recording;
    }

    /** One group of rows is kept of so many: 1 where the picture has at most a million pixels. */
    private static int rowStep(FillTask task) {
        long pixels = task.rows().stream().mapToLong(String::length).sum();
        return pixels <= MOST_ITEMS ? 1 : (int) (2 * pixels / MOST_ITEMS + 1);
    }

    /** Groups of rows, the seed's among them. */
    private static PixelPredicate part(FillTask task) {
        int step = rowStep(task);
        int seed = task.y() / ROWS_TOGETHER;
        return (x, y) -> (y / ROWS_TOGETHER - seed) % step == 0;
    }

    @Override
    public long spend(SeedFiller method, FillTask task) {
        return watched(method, task).writes();
    }

    private static WatchedPicture watched(SeedFiller method, FillTask task) {
        var text = new TextPicture(task.rows());
        var counting = new CountingPixels(2L * text.width() * text.height());
        var picture = new WatchedPicture(text, counting);
        method.fill(picture, task.x(), task.y(), task.with(), task.connectivity());
        return picture;
    }

    @Override
    public PixelRecording exact(FillTask task, int limit) {
        var recording = new PixelRecording(limit);
        new ExactSeedFill(task)
                .fill(
                        (x, y) -> {
                            if (recording.size() < limit) recording.plot(x, y);
                        });
        return recording;
    }

    @Override
    public Deviation compare(FillTask task, PixelRecording exact, PixelRecording actual) {
        return SetComparison.compare(exact, actual);
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() == 0;
    }

    @Override
    public Map<String, Long> operations(SeedFiller method, FillTask task) {
        WatchedPicture picture = watched(method, task);
        return Map.of("pixel reads", picture.reads(), "pixel writes", picture.writes());
    }

    @Override
    public int mostItems() {
        return MOST_ITEMS;
    }

    @Override
    public String item() {
        return "pixel";
    }

    @Override
    public String errorUnit() {
        return "pixels";
    }

    @Override
    public Format<SeedFiller, FillTask, PixelRecording> format() {
        return new FillFormat(this);
    }
}
