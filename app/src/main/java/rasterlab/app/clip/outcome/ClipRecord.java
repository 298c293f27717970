package rasterlab.app.clip.outcome;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.clip.PartCapture;
import rasterlab.engine.study.Deviation;

/** Records what a method does to segments while it runs. */
public final class ClipRecord {
    private final String method;
    private final boolean decidesByCode;
    private final List<ClipStep> steps = new ArrayList<>();
    private final PartCapture capture = new PartCapture(Integer.MAX_VALUE);
    private Clipping.ClipEnding ending = Clipping.ClipEnding.ENDED;
    private String message = "";

    /**
     * @param decidesByCode as {@link Clipping#decidesByCode}
     */
    public ClipRecord(String method, boolean decidesByCode) {
        this.method = method;
        this.decidesByCode = decidesByCode;
    }

    public PartCapture sink() {
        return capture;
    }

    void add(ClipStep step) {
        steps.add(step);
    }

    /** Closes the account of one segment. */
    void next() {
        capture.next();
    }

    /** Closes it with the step of a method that tells nothing but what it sent. */
    public void written(int item) {
        next();
        List<Optional<double[]>> sent = capture.captured().parts();
        add(ClipStep.written(item, sent.get(sent.size() - 1).orElse(new double[0])));
    }

    void endless() {
        end(Clipping.ClipEnding.ENDLESS, "");
    }

    void refuse(String reason) {
        end(Clipping.ClipEnding.REFUSED, reason);
    }

    /** Runs something a method may refuse or crash in; the first such end counts. */
    void attempt(Runnable part) {
        try {
            part.run();
        } catch (IllegalArgumentException e) {
            refuse(e.getMessage());
        } catch (RuntimeException e) {
            end(Clipping.ClipEnding.CRASHED, e.toString());
        }
    }

    private void end(Clipping.ClipEnding how, String why) {
        if (ending != Clipping.ClipEnding.ENDED) return;
        ending = how;
        message = why;
    }

    /**
     * @param unit size of the window or volume
     */
    public Clipping clipping(
            ClippedEnds exact, Function<ClippedEnds, Deviation> comparison, double unit) {
        while (capture.captured().parts().size() < exact.parts().size()) capture.next();
        List<Optional<double[]>> parts = capture.captured().parts();
        var left = new ArrayList<Clipping.ClipPart>();
        for (int i = 0; i < parts.size(); i++) {
            int item = i;
            parts.get(i).ifPresent(ends -> left.add(new Clipping.ClipPart(item, ends)));
        }
        return new Clipping(
                method,
                decidesByCode,
                steps,
                left,
                ending,
                message,
                comparison.apply(capture.captured()),
                WrongParts.between(present(exact.parts()), present(parts), unit));
    }

    /**
     * The part of a segment that a step left: none where the interval of t ends before its
     * beginning, or is no interval.
     */
    double[] remaining(double[] ends, double[] left) {
        if (decidesByCode) return left;
        int dimension = ends.length / 2;
        double along = 0;
        for (int i = 0; i < dimension; i++)
            along += (left[dimension + i] - left[i]) * (ends[dimension + i] - ends[i]);
        return along >= 0 ? left : new double[0];
    }

    private static List<double[]> present(List<Optional<double[]>> parts) {
        return parts.stream().flatMap(Optional::stream).toList();
    }
}
