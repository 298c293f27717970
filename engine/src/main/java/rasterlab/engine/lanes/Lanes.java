package rasterlab.engine.lanes;

import java.util.function.Supplier;

/** How many numbers are computed at a time; the results are the same bit for bit. */
public enum Lanes {
    /** One after the other, in plain Java. */
    ONE,
    /** Eight, with the Vector API. */
    EIGHT;

    private static final String MODULE = "jdk.incubator.vector";

    /** A system property; {@code false} switches the Vector API off. */
    private static final String SWITCH = "rasterlab.vector";

    /** Bits of eight ints or floats. */
    private static final int BITS = 256;

    private static final String MISSING = findMissing();

    private static String findMissing() {
        if (!Boolean.parseBoolean(System.getProperty(SWITCH, "true")))
            return "switched off by -D%s=false".formatted(SWITCH);
        if (ModuleLayer.boot().findModule(MODULE).isEmpty())
            return "Java was started without --add-modules " + MODULE;
        int bits = vectorPart(WidestVector.class, "WidestVectorHere").bits();
        return bits < BITS ? "vectors have %d bits here, not %d".formatted(bits, BITS) : "";
    }

    /** How wide vectors are. */
    interface WidestVector {
        /** Bits of the widest vector that this machine computes with at once. */
        int bits();
    }

    /** Eight where that is possible here. */
    public static Lanes best() {
        return MISSING.isEmpty() ? EIGHT : ONE;
    }

    /** Why there are no eight lanes here; empty where there are. */
    public static String missing() {
        return MISSING;
    }

    /**
     * The part that does a thing in so many lanes.
     *
     * @param kind what the part is; its package holds the one that needs the Vector API
     * @param plain makes the part for one lane
     * @param vector name of the class for eight lanes, which has a constructor without parameters
     * @throws IllegalStateException where there are not so many lanes
     */
    public <T> T part(Class<T> kind, Supplier<? extends T> plain, String vector) {
        if (this == ONE) return plain.get();
        if (!MISSING.isEmpty()) throw new IllegalStateException("no eight lanes: " + MISSING);
        return vectorPart(kind, vector);
    }

    private static <T> T vectorPart(Class<T> kind, String name) {
        try {
            var constructor =
                    Class.forName(kind.getPackageName() + "." + name).getDeclaredConstructor();
            constructor.setAccessible(true);
            return kind.cast(constructor.newInstance());
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("the engine was built without its vector part", e);
        }
    }
}
