package rasterlab.engine.naming;

import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;

/** Finds one of several things by its name. */
public final class Named {
    private Named() {}

    /**
     * The first one of that name.
     *
     * @param kind what they are, in the singular, for the message
     * @param nameOf the name of each
     * @throws IllegalArgumentException if there is none; the message lists those there are
     */
    public static <T> T find(
            String kind, String name, List<? extends T> all, Function<? super T, String> nameOf) {
        for (T each : all) if (nameOf.apply(each).equals(name)) return each;
        String known = all.stream().map(nameOf).collect(Collectors.joining(", "));
        throw new IllegalArgumentException("no %s '%s'; there are %s".formatted(kind, name, known));
    }
}
