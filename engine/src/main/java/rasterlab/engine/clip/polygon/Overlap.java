package rasterlab.engine.clip.polygon;

/** Whether a subject and a convex window share an area, decided without rounding. */
final class Overlap {
    private Overlap() {}

    /**
     * Whether the two have area in common: part of the subject's boundary runs strictly inside the
     * window, or none does and one of the two lies in the other.
     */
    static boolean isAny(Ring window, Ring subject) {
        return !new InnerChains(window, subject).chains().isEmpty()
                || Enclosure.of(window, subject).isPresent();
    }
}
