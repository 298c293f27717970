package rasterlab.app.study;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.HazardTrial.VerdictCell;
import rasterlab.engine.study.Topic;

/**
 * The hazards of a topic on each of its methods and the user's own program.
 *
 * @param topic with its own methods alone
 */
record HazardRuns(Topic<?, ?, ?> topic, OwnMethods own) {
    /**
     * Tries all, until the thread is interrupted.
     *
     * @param judged told each verdict, on this thread
     */
    List<VerdictCell> tried(Consumer<VerdictCell> judged) {
        BooleanSupplier cancelled = Thread.currentThread()::isInterrupted;
        var cells =
                new ArrayList<>(
                        HazardTrial.table(topic, HazardTrial.WALL_LIMIT, judged, cancelled));
        own.of(topic.name())
                .map(program -> new OwnStudy<>(topic, program, own).hazards(judged, cancelled))
                .ifPresent(cells::addAll);
        return cells;
    }

    /** The verdicts on the topic's own methods alone. */
    static List<VerdictCell> withoutOwn(List<VerdictCell> cells) {
        return cells.stream().filter(one -> !one.method().equals(OwnMethods.NAME)).toList();
    }
}
