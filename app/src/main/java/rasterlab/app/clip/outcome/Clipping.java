package rasterlab.app.clip.outcome;

import java.util.List;
import java.util.Optional;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.study.Deviation;

/**
 * The result of one method for the scene, beside the exact answer.
 *
 * @param method its name
 * @param decidesByCode whether its steps decide by a region's code, not by t
 * @param steps in order; of an endless walk the first {@value #RECORDED}
 * @param parts what is left: of each segment in turn, or the pieces of the polygon
 * @param message what the method said when it refused or crashed; else empty
 * @param deviation from the exact answer
 * @param wrong what is missing and what is too much
 */
public record Clipping(
        String method,
        boolean decidesByCode,
        List<ClipStep> steps,
        List<ClipPart> parts,
        ClipEnding ending,
        String message,
        Deviation deviation,
        WrongParts wrong) {
    /** The most steps of one segment that are kept. */
    static final int RECORDED = 200;

    /** How the method came to its end. */
    public enum ClipEnding {
        ENDED,
        /** The method went on although a segment needs no more steps. */
        ENDLESS,
        REFUSED,
        CRASHED
    }

    /**
     * Something that is left.
     *
     * @param item index of the segment; 0 for a polygon
     * @param coordinates point after point
     */
    public record ClipPart(int item, double[] coordinates) {
        public ClipPart {
            Bounds.requireAtLeast("item", item, 0);
        }
    }

    public Clipping {
        steps = List.copyOf(steps);
        parts = List.copyOf(parts);
    }

    /** The rest of one segment, if there is any. */
    public Optional<ClipPart> part(int item) {
        return parts.stream().filter(part -> part.item() == item).findFirst();
    }

    /** Whether nothing is wrong by more than the topic allows. */
    public boolean isRight() {
        return ending == ClipEnding.ENDED && wrong.isEmpty();
    }
}
