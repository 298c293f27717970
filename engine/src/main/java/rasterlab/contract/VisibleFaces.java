package rasterlab.contract;

/**
 * Tells which faces of a body are turned towards the eye.
 *
 * <p>A face is a flat polygon whose corners go counter-clockwise seen from outside. Its plane
 * passes through its first corner c₀, at right angles to n = ½·Σ cᵢ × cᵢ₊₁, which points outwards.
 * It is turned towards the eye where n·(eye − c₀) &gt; 0, for the numbers exactly as given. An eye
 * in the plane sees the face edge on, and a face without area has n = 0: neither is visible.
 *
 * <p>Of one convex body these are the faces that are seen. Of any other body they are those that
 * may be seen, and another face can still hide them.
 */
@FunctionalInterface
public interface VisibleFaces {
    /**
     * Whether each face is turned towards the eye.
     *
     * <p>A method that judges by the inner point may refuse a body where that point is not behind
     * every face, or where a face has no area. No other body may be refused.
     *
     * @param xyz x, y, z of vertex 0, then of vertex 1, …; any finite numbers, in any unit; not to
     *     be changed
     * @param faces the corners of each face as vertex numbers from 0, at least three; not to be
     *     changed
     * @param eye x, y, z
     * @param inside x, y, z of a point inside the body, which is behind every face; or no numbers,
     *     for the mean of the vertices; changes no answer
     * @return one answer for each face, in their order
     * @throws IllegalArgumentException if a number is not finite, a corner is no vertex, a face has
     *     fewer than three, or the inner point is refused as said above; the message names place,
     *     value and what is allowed
     */
    boolean[] visible(double[] xyz, int[][] faces, double[] eye, double[] inside);
}
