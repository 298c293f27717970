package rasterlab.app.shell;

import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Function;
import rasterlab.app.canvas.Unshown;

/**
 * How a topic's inputs come into a tab.
 *
 * @param tab its name; "" where there is none
 * @param obstacle why the tab cannot show an input; empty where it can
 * @param show shows an input without an obstacle by a method of the topic, "" for the tab's own
 */
record TopicWay(
        String tab,
        Function<TopicInput, Optional<Unshown>> obstacle,
        BiConsumer<TopicInput, String> show) {
    /** No input can be shown. */
    static TopicWay none(Unshown why) {
        return new TopicWay(
                "",
                input -> Optional.of(why),
                (input, method) -> {
                    throw new IllegalArgumentException(input.name());
                });
    }
}
