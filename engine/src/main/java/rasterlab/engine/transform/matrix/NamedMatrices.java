package rasterlab.engine.transform.matrix;

import java.util.List;
import java.util.stream.Stream;
import rasterlab.engine.naming.Named;

/** The list of every named matrix there is, in the course's order. */
public final class NamedMatrices {
    private static final List<NamedMatrix> ALL =
            Stream.of(
                            PlaneNames.all(),
                            SpaceNames.all(),
                            ProjectionNames.all(),
                            ViewNames.all(),
                            CurveNames.all())
                    .flatMap(List::stream)
                    .toList();

    private NamedMatrices() {}

    public static List<NamedMatrix> all() {
        return ALL;
    }

    /**
     * The matrix of that name.
     *
     * @throws IllegalArgumentException if there is none; lists those there are
     */
    public static NamedMatrix named(String name) {
        return Named.find("matrix", name, ALL, NamedMatrix::name);
    }
}
