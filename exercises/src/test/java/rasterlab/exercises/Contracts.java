package rasterlab.exercises;

import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;

/** The topics that students can be asked for, and their contracts. */
public final class Contracts {
    private static final String PACKAGE = LineRasterizer.class.getPackageName();

    private Contracts() {}

    /** All but the one whose methods draw whole pictures of the engine's own scenes. */
    public static List<Topic<?, ?, ?>> topics() {
        return Topics.all().stream()
                .filter(topic -> !topic.name().equals("hidden-surfaces"))
                .toList();
    }

    public static List<Class<?>> all() {
        return topics().stream().<Class<?>>map(Contracts::of).distinct().toList();
    }

    /** The interface of the contracts' package that the topic's methods implement. */
    public static Class<?> of(Topic<?, ?, ?> topic) {
        return interfaces(topic.methods().get(0).implementation().getClass())
                .filter(type -> type.getPackageName().equals(PACKAGE))
                .findFirst()
                .orElseThrow();
    }

    private static Stream<Class<?>> interfaces(Class<?> type) {
        if (type == null) return Stream.of();
        Stream<Class<?>> above =
                Stream.of(type.getInterfaces())
                        .flatMap(one -> Stream.concat(Stream.of(one), interfaces(one)));
        return Stream.concat(above, interfaces(type.getSuperclass()));
    }
}
