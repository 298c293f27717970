package rasterlab.app.shell;

import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import rasterlab.app.canvas.HazardNote;
import rasterlab.app.canvas.Unlike;

/**
 * How a topic's inputs come into a tab.
 *
 * @param tab its name
 * @param show shows an input by a method of the topic, "" for the tab's own
 * @param unlike in what the tab then shows it otherwise than it is
 * @param note says so beside the picture
 */
record TopicWay(
        String tab,
        BiConsumer<TopicInput, String> show,
        BiFunction<TopicInput, String, List<Unlike>> unlike,
        Consumer<HazardNote> note) {
    /** A tab that shows every input of the topic as it is. */
    static TopicWay whole(String tab, BiConsumer<TopicInput, String> show) {
        return new TopicWay(tab, show, (input, method) -> List.of(), note -> {});
    }
}
