package rasterlab.app.canvas;

import java.awt.Component;
import java.awt.Container;
import java.util.function.Predicate;
import java.util.stream.Stream;

/** Lists the components in a container, each with all that is in it behind it. */
public final class Parts {
    private Parts() {}

    public static Stream<Component> of(Container place) {
        return in(place, each -> true);
    }

    /** Lists the components that are shown, in one that is shown itself. */
    public static Stream<Component> shown(Container place) {
        return in(place, Component::isVisible);
    }

    private static Stream<Component> in(Container place, Predicate<Component> wanted) {
        return Stream.of(place.getComponents())
                .filter(wanted)
                .flatMap(
                        each ->
                                each instanceof Container inner
                                        ? Stream.concat(Stream.of(each), in(inner, wanted))
                                        : Stream.of(each));
    }
}
