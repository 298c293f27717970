package rasterlab.engine.visibility.order;

import java.util.List;
import rasterlab.contract.DepthOrder;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that order polygons by depth, in teaching order. */
final class DepthOrderMethods {
    private DepthOrderMethods() {}

    static List<Method<DepthOrder>> all() {
        return List.of(
                new Method<>(
                        "mean-z-textbook",
                        new About(
                                "z = (z₁ + z₂ + z₃) / 3, each rounded to a whole number",
                                "what is left is nearer by this measure than what is painted",
                                "n·(n + 1)/2 comparisons for n polygons",
                                "polygons that overlap in depth; those less than a unit apart;"
                                        + " a fourth corner far from the three",
                                "student's coursework, three-dimensional model of a vase, program"
                                        + " listing"),
                        new MeanZTextbook()),
                new Method<>(
                        "mean-z",
                        new About(
                                "z = Σ zᵢ / m over all m corners",
                                "what is left is nearer by this measure than what is painted",
                                "about n·log₂ n comparisons for n polygons",
                                "polygons that overlap in depth, in a circle or through each other",
                                "the painter's algorithm of the course, by all corners"),
                        new MeanZ()),
                new Method<>(
                        "newell",
                        new About(
                                "P, with the farthest corner, first, if for each Q that overlaps"
                                        + " it in depth one of five tests says yes; else Q before"
                                        + " P, and in a circle one is cut",
                                "nothing painted hides anything that is left",
                                "up to five tests for each two polygons that overlap in depth,"
                                        + " again after moves and cuts: up to n² for n polygons,"
                                        + " but 15,000 of 131,000 pairs for 512 scattered ones",
                                "none known in front of the eye; refuses what reaches behind it,"
                                        + " polygons narrower or nearer to the eye than 10⁻⁶ of"
                                        + " the largest coordinate, and what needs more than"
                                        + " 1,000,000 pieces or 500,000,000 comparisons, some"
                                        + " seconds",
                                "M. E. Newell, R. G. Newell, T. L. Sancha, A solution to the"
                                        + " hidden surface problem, 1972"),
                        new Newell()),
                new Method<>(
                        "bsp",
                        new About(
                                "far side of a polygon's plane, the plane, its near side, and each"
                                        + " side likewise",
                                "nothing on the far side of a plane hides anything on the near one",
                                "five planes tried against the polygons of each node, about"
                                        + " 6·n·log₂ n for n scattered ones, 3·n² for convex"
                                        + " bodies",
                                "none known; cuts polygons that no circle forces to be cut; refuses"
                                        + " polygons narrower or nearer to the eye than 10⁻⁶ of"
                                        + " the largest coordinate, and what needs more than"
                                        + " 1,000,000 pieces",
                                "H. Fuchs, Z. M. Kedem, B. F. Naylor, On visible surface generation"
                                        + " by a priori tree structures, 1980"),
                        new Bsp()));
    }
}
