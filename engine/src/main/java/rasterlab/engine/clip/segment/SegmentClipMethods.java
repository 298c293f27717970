package rasterlab.engine.clip.segment;

import java.util.List;
import rasterlab.contract.SegmentClipper;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that clip a segment, in teaching order; each is a {@link SteppedSegmentClipper}. */
final class SegmentClipMethods {
    private SegmentClipMethods() {}

    static List<Method<SegmentClipper>> all() {
        return List.of(
                fourLines(),
                cohenSutherlandTextbook(),
                cohenSutherlandNestedTextbook(),
                cohenSutherlandFloatTextbook(),
                cohenSutherland(),
                liangBarsky(),
                branchlessLiangBarsky(),
                midpoint(),
                cyrusBeck());
    }

    private static Method<SegmentClipper> fourLines() {
        return new Method<>(
                "four-lines",
                new About(
                        "t = (side − x0)/(x1 − x0), y = y0 + t·(y1 − y0); counts where 0 ≤ t ≤ 1"
                                + " and ymin ≤ y ≤ ymax; the same with x and y exchanged",
                        "the ends of what is left are ends in the window or points that count",
                        "four divisions, wherever the segment lies",
                        "none known; corners nearer than rounding are handed over to unrounded"
                                + " arithmetic",
                        "the definition: the line through the segment meets the four lines of"
                                + " the sides"),
                new FourLines());
    }

    private static Method<SegmentClipper> cohenSutherlandTextbook() {
        return new Method<>(
                "cohen-sutherland-textbook",
                new About(
                        "y1 ← y1 + (y2 − y1)/(x2 − x1)·(side − x1) in whole numbers",
                        "the first end, made the one outside by swapping, is moved onto a side",
                        "a division and a multiplication for each cut",
                        "draws segments wholly outside; the quotient of whole numbers makes every"
                                + " slope below 1 a 0; fractions are lost; overflow from 2³⁰ on",
                        "the course's lecture text on clipping, listing in whole numbers"),
                new CohenSutherlandTextbook());
    }

    private static Method<SegmentClipper> cohenSutherlandNestedTextbook() {
        return new Method<>(
                "cohen-sutherland-nested-textbook",
                new About(
                        "above: x1 ← x1 + (x2 − x1)·(ymax − y1)/(y2 − y1); right: y1 ← x1 + (y2 −"
                                + " y1)·(ymax − x1)/(x2 − x1), left with ymin",
                        "none; only ends above the window are moved as they should be",
                        "a multiplication and a division for each cut",
                        "endless for an end only below, only right or only left; x1 in place of"
                                + " y1, ymax and ymin in place of xmax and xmin to the right and"
                                + " left; NaN counts as inside",
                        "the course's textbook, chapter on clipping, procedure CLIP"),
                new CohenSutherlandNestedTextbook());
    }

    private static Method<SegmentClipper> cohenSutherlandFloatTextbook() {
        return new Method<>(
                "cohen-sutherland-float-textbook",
                new About(
                        "m = (y2 − y1)/(x2 − x1), once; above, below: x1 ← x1 + (side − y1)/m;"
                                + " right, left: y1 ← y1 + m·(side − x1)",
                        "none; the moved end is on a line of the rounded slope, not of the segment",
                        "a division for the slope; for each cut a division, or a multiplication",
                        "endless where the other end lies at a corner that the rounded line passes"
                                + " outside; corners missed by a rounding are drawn; NaN counts as inside",
                        "the method as commonly written in real numbers with the slope saved"),
                new CohenSutherlandFloatTextbook());
    }

    private static Method<SegmentClipper> cohenSutherland() {
        return new Method<>(
                "cohen-sutherland",
                new About(
                        "code, highest bit first: signs of x − xmin, xmax − x, y − ymin, ymax − y; nothing left"
                                + " where c0 ∧ c1 ≠ 0, all left where c0 ∨ c1 = 0",
                        "every code is the exact one; a cut end never gets a removed bit back",
                        "eight signs, and a division for each cut, at most four",
                        "none known; corners nearer than rounding are handed over to unrounded"
                                + " arithmetic",
                        "D. Cohen and I. Sutherland, in W. M. Newman and R. F. Sproull,"
                                + " Principles of Interactive Computer Graphics, 1973"),
                new CohenSutherland());
    }

    private static Method<SegmentClipper> liangBarsky() {
        return new Method<>(
                "liang-barsky",
                new About(
                        "p = −dx, dx, −dy, dy; q = x0 − xmin, xmax − x0, y0 − ymin, ymax − y0;"
                                + " t = q/p enters where p < 0, leaves where p > 0",
                        "what is left of the sides so far is enter ≤ t ≤ leave",
                        "a division for each side it is not parallel to, until nothing is left: at"
                                + " most four",
                        "none known; intervals about as short as rounding are handed over to"
                                + " unrounded arithmetic",
                        "Y.-D. Liang and B. A. Barsky, A new concept and method for line"
                                + " clipping, ACM Transactions on Graphics 3(1), 1984"),
                new LiangBarsky());
    }

    private static Method<SegmentClipper> branchlessLiangBarsky() {
        return new Method<>(
                "liang-barsky-branchless",
                new About(
                        "enter = max(0, (near − x0)/(x1 − x0), the same in y); back = max(0, (x1 −"
                                + " far)/(x1 − x0), the same in y); left where enter + back < 1",
                        "what is left of the sides so far is enter ≤ t ≤ 1 − back",
                        "two divisions and four multiplications, none where both ends are beyond"
                                + " one side",
                        "none known; intervals about as short as rounding are handed over to"
                                + " unrounded arithmetic",
                        "Y.-D. Liang and B. A. Barsky, A new concept and method for line"
                                + " clipping, ACM Transactions on Graphics 3(1), 1984"),
                new BranchlessLiangBarsky());
    }

    private static Method<SegmentClipper> midpoint() {
        return new Method<>(
                "midpoint",
                new About(
                        "t = (a + b)/2; keep the half that holds the wanted point",
                        "the wanted end lies between a visible and an invisible t",
                        "a halving and four comparisons for each bit of an end; no division",
                        "none known; middles within rounding of a side are handed over to"
                                + " unrounded arithmetic while a visible point is sought",
                        "R. F. Sproull and I. E. Sutherland, A clipping divider, AFIPS Fall Joint"
                                + " Computer Conference, 1968"),
                new MidpointClip());
    }

    private static Method<SegmentClipper> cyrusBeck() {
        return new Method<>(
                "cyrus-beck",
                new About(
                        "t = −n·(p0 − c)/(n·(p1 − p0)) for each edge with corner c, inward normal n",
                        "what is left of the edges so far is enter ≤ t ≤ leave",
                        "four multiplications and a division for each edge, for any convex window",
                        "none known; intervals about as short as rounding, and windows without"
                                + " area, whose edges have no normal, are handed over to unrounded"
                                + " arithmetic",
                        "M. Cyrus and J. Beck, Generalized two- and three-dimensional clipping,"
                                + " Computers and Graphics 3, 1978"),
                new CyrusBeck());
    }
}
