package rasterlab.engine.naming;

import java.util.Collection;
import java.util.List;
import java.util.function.Function;

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
        throw new IllegalArgumentException(unknown(kind, name, all.stream().map(nameOf).toList()));
    }

    /**
     * Says that there is nothing of a name, what there is, and which of it may have been meant.
     *
     * @param kind what they are, in the singular
     */
    public static String unknown(String kind, String name, Collection<String> known) {
        return "no %s '%s'; there are %s".formatted(kind, name, String.join(", ", known))
                + suggestion(name, known);
    }

    /**
     * The end of a complaint about a name: which one may have been meant; "" where none is near.
     */
    public static String suggestion(String name, Collection<String> known) {
        return Closest.to(name, known).map(near -> "; did you mean '" + near + "'?").orElse("");
    }
}
