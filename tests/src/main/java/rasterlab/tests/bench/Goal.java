package rasterlab.tests.bench;

import java.util.Map;

/**
 * A wanted ratio between a peer's time and ours.
 *
 * @param work what both do, for the table
 * @param benchmark the class that holds both
 * @param ours name of our benchmark method
 * @param peer name of the peer's
 * @param parameters the values of the class's parameters at which the two are compared
 * @param ratio the peer's time divided by ours, at least
 */
public record Goal(
        String work,
        Class<?> benchmark,
        String ours,
        String peer,
        Map<String, String> parameters,
        double ratio) {
    public Goal {
        parameters = Map.copyOf(parameters);
        requireMethod(benchmark, ours);
        requireMethod(benchmark, peer);
        if (!(ratio > 0)) throw new IllegalArgumentException("ratio must be above 0, got " + ratio);
    }

    private static void requireMethod(Class<?> benchmark, String name) {
        for (var method : benchmark.getMethods()) if (method.getName().equals(name)) return;
        throw new IllegalArgumentException(
                benchmark.getSimpleName() + " has no public method '" + name + "'");
    }
}
