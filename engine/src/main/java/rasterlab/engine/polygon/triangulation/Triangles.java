package rasterlab.engine.polygon.triangulation;

import java.util.Arrays;

/** Triples of corner numbers: the output of a method that triangulates. */
public final class Triangles {
    private final int[] triples;

    /**
     * @param triples three numbers each, taken as they are
     * @throws IllegalArgumentException if their count is no multiple of 3
     */
    public Triangles(int... triples) {
        if (triples.length % 3 != 0)
            throw new IllegalArgumentException(
                    "triangles need three corners each, got " + triples.length + " in all");
        this.triples = triples;
    }

    public int size() {
        return triples.length / 3;
    }

    /** Number of the corner {@code corner}, from 0 to 2, of a triangle. */
    public int corner(int triangle, int corner) {
        return triples[3 * triangle + corner];
    }

    /** The first {@code limit} triangles, or all if there are fewer. */
    public Triangles first(int limit) {
        return new Triangles(Arrays.copyOf(triples, 3 * Math.min(limit, size())));
    }

    String name(int triangle) {
        return "triangle "
                + triangle
                + " ("
                + corner(triangle, 0)
                + ", "
                + corner(triangle, 1)
                + ", "
                + corner(triangle, 2)
                + ")";
    }

    @Override
    public String toString() {
        return Arrays.toString(triples);
    }
}
