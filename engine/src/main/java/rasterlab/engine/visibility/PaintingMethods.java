package rasterlab.engine.visibility;

import java.util.List;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** Methods that paint faces or pieces of them, the farthest first. */
final class PaintingMethods {
    private static final String COURSEWORK =
            "student's coursework \"three-dimensional model of a vase\"";

    private PaintingMethods() {}

    static List<Method<Visibility>> all() {
        return List.of(
                new Method<>("painter-textbook", textbook(), new TextbookPainter()),
                new Method<>("painter", painter(), new Painter()),
                new Method<>("newell", newell(), new OrderedPieces("newell")),
                new Method<>("bsp", bsp(), new OrderedPieces("bsp")));
    }

    private static About textbook() {
        return new About(
                "depth = (z1 + z2 + z3) / 3 of coordinates rounded to whole units",
                "every face drawn so far has a mean z at least as large as the next",
                "N² comparisons, every pixel of every face is written",
                "rounding moves edges by up to a pixel and merges depths; a mean cannot order faces"
                        + " that overlap in depth",
                COURSEWORK);
    }

    private static About painter() {
        return new About(
                "depth = mean z of all corners in eye space",
                "every face drawn so far has a mean z at least as large as the next",
                "N·log N comparisons, every pixel of every face is written",
                "long faces beside short ones, cyclic overlap, faces that pierce each other",
                COURSEWORK + ", repaired");
    }

    private static About newell() {
        return new About(
                "the farthest face first if one of five tests says for each other that overlaps it"
                        + " in depth that it hides nothing of it; in a circle one is cut",
                "nothing painted hides anything that is left",
                "up to N² tests and more after cuts, every pixel of every face is written",
                "none known for corners within 1000·ρ; refuses scenes that need too many comparisons"
                        + " or pieces, and faces that the view makes too narrow",
                "M. E. Newell, R. G. Newell, T. L. Sancha, A solution to the hidden surface"
                        + " problem, 1972");
    }

    private static About bsp() {
        return new About(
                "the far side of a face's plane, the plane, its near side, each side likewise",
                "nothing on the far side of a plane hides anything on its near side",
                "N·log N to N² tests, every pixel of every face is written",
                "none known for corners within 1000·ρ; cuts faces that no circle forces to be cut, and"
                        + " refuses too many pieces and faces that the view makes too narrow",
                "H. Fuchs, Z. M. Kedem, B. F. Naylor, On visible surface generation by a priori"
                        + " tree structures, SIGGRAPH 1980");
    }
}
