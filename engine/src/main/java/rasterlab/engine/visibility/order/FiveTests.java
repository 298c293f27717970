package rasterlab.engine.visibility.order;

import java.util.Map;

/**
 * The five tests of Newell, Newell and Sancha, in their order: each, if it says yes, shows that P
 * hides nothing of Q and may be painted before it.
 *
 * <ol>
 *   <li>the extents in x do not overlap on the picture;
 *   <li>nor those in y;
 *   <li>P is wholly on the far side of Q's plane;
 *   <li>Q is wholly on the near side of P's plane;
 *   <li>the outlines do not overlap: an edge of one has the other on its outer side.
 * </ol>
 *
 * <p>Of polygons in one plane, for which both tests of planes say yes, the earlier is to be seen: P
 * may hide Q if it is the earlier and their outlines overlap.
 *
 * <p>Source: M. E. Newell, R. G. Newell, T. L. Sancha, A solution to the hidden surface problem,
 * ACM Annual Conference, 1972, pp. 443–450.
 */
final class FiveTests {
    private final long[] asked = new long[5];
    private long comparisons;

    /** Whether P may hide something of Q, all tests having said no. */
    boolean mayHide(FacetExtent p, FacetExtent q) {
        comparisons++;
        if (p.clearlyBehind(q) || yes(0, p.apartInX(q)) || yes(1, p.apartInY(q))) return false;
        int sidesOfQ = sides(2, q.facet(), p.facet());
        if (sidesOfQ == EyePlane.FAR) return false;
        int sidesOfP = sides(3, p.facet(), q.facet());
        if (sidesOfQ == 0 || sidesOfP == 0)
            return p.facet().polygon() < q.facet().polygon() && !outlinesApart(p, q);
        boolean clear =
                p.behind(q) || (sidesOfQ & EyePlane.NEAR) == 0 || (sidesOfP & EyePlane.FAR) == 0;
        return !clear && !outlinesApart(p, q);
    }

    private boolean yes(int test, boolean answer) {
        asked[test]++;
        return answer;
    }

    /** The sides of one's plane on which the other has corners. */
    private int sides(int test, Facet one, Facet other) {
        asked[test]++;
        return one.plane().sides(other.seen());
    }

    private boolean outlinesApart(FacetExtent p, FacetExtent q) {
        asked[4]++;
        return edgeParts(p.facet(), q.facet()) || edgeParts(q.facet(), p.facet());
    }

    private static boolean edgeParts(Facet one, Facet other) {
        for (int edge = 0; edge < one.seen().length / 3; edge++)
            if (parts(EyePlane.throughEdge(one, edge), one, other)) return true;
        return false;
    }

    /**
     * Whether the plane has one on its inner side and the other on its outer one. Rounding may turn
     * an edge between two corners of cuts that are all but one the other way round, with its own
     * polygon outside: that parts nothing, nor does an edge that points at the eye and has no
     * plane.
     */
    private static boolean parts(EyePlane plane, Facet one, Facet other) {
        boolean none = plane.nx() == 0 && plane.ny() == 0 && plane.nz() == 0;
        return !none
                && (plane.sides(other.seen()) & EyePlane.NEAR) == 0
                && (plane.sides(one.seen()) & EyePlane.FAR) == 0;
    }

    long comparisons() {
        return comparisons;
    }

    Map<String, Long> operations() {
        return Map.of(
                "comparisons", comparisons,
                "x extents compared", asked[0],
                "y extents compared", asked[1],
                "far sides asked", asked[2],
                "near sides asked", asked[3],
                "outlines compared", asked[4]);
    }
}
