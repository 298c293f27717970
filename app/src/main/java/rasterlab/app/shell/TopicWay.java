package rasterlab.app.shell;

import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Predicate;
import rasterlab.app.canvas.HazardNote;
import rasterlab.app.canvas.Unlike;

/**
 * How a topic's inputs come into a tab.
 *
 * @param tab its name
 * @param show shows an input by a method of the topic, "" for the tab's own
 * @param notes what is said of inputs that the tab cannot show as they are; empty for a tab that
 *     can
 */
record TopicWay(String tab, BiConsumer<TopicInput, String> show, Optional<Notes> notes) {
    /**
     * What is said beside a picture.
     *
     * @param unlike in what the tab shows an input otherwise than it is; on any thread
     * @param drawsBy whether the picture shows what that method does
     * @param note says so beside the picture that is shown
     */
    record Notes(
            BiFunction<TopicInput, String, List<Unlike>> unlike,
            Predicate<String> drawsBy,
            Consumer<HazardNote> note) {}

    /** A tab that shows every input of the topic as it is. */
    static TopicWay whole(String tab, BiConsumer<TopicInput, String> show) {
        return new TopicWay(tab, show, Optional.empty());
    }
}
