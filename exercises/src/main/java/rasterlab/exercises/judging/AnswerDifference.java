package rasterlab.exercises.judging;

import java.util.Set;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.score.Message;

/** Says how an answer differs from another one, in words that fit its kind. */
final class AnswerDifference {
    /**
     * Topics with many right answers to an input: what is wrong is not where one of them differs.
     */
    private static final Set<String> OF_MANY_ANSWERS =
            Set.of("triangulate", "depth-order", "clip-polygon");

    private AnswerDifference() {}

    /** The first part of an answer that differs, and how far all of it is from right. */
    static <C, I, O> Message of(Topic<C, I, O> topic, I input, O exact, O actual) {
        if (exact instanceof PixelRecording right && actual instanceof PixelRecording mine)
            return new PixelErrors(right, mine).message();
        String first = topic.compare(input, exact, actual).first();
        boolean free = OF_MANY_ANSWERS.contains(topic.name()) || isFlattening(input);
        return free && !first.isEmpty()
                ? Message.of("answer.engine", first)
                : Leaves.difference(topic, input, exact, actual);
    }

    /** Whether every polyline along the curve within a tolerance is right, whatever its points. */
    private static boolean isFlattening(Object input) {
        return input instanceof CurveTask task && task.flatness() > 0;
    }

    /** Says of an answer whose mistake has no name what its kind alone tells; else nothing. */
    static Message kind(Object right, Object actual) {
        return right instanceof PixelRecording wanted
                        && actual instanceof PixelRecording drawn
                        && new PixelErrors(wanted, drawn).isAgainAlone()
                ? Message.of("mistake.again")
                : Message.NONE;
    }

    /**
     * The first part of an answer that differs from what it would be if it fitted the others.
     *
     * @param wanted what it would be then
     * @param ordered whether its items are told by their places in it
     */
    static <C, I, O> Message unfit(
            Topic<C, I, O> topic, I input, O wanted, O actual, boolean ordered) {
        return !ordered
                        && wanted instanceof PixelRecording right
                        && actual instanceof PixelRecording mine
                ? new PixelErrors(right, mine).unfit()
                : Leaves.unfit(topic, input, wanted, actual);
    }
}
