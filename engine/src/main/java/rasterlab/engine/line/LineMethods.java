package rasterlab.engine.line;

import java.util.List;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that draw a segment, in teaching order; each is a {@link SteppedLine}. */
final class LineMethods {
    private static final String PONOMAREV =
            "V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, fig. ";
    private static final String KAZANTSEV =
            "A. V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch. 4";

    private LineMethods() {}

    static List<Method<LineRasterizer>> all() {
        return List.of(
                naiveTextbook(),
                naive(),
                floatDda(),
                dda(),
                bresenhamFirstTextbook(),
                bresenhamPascalTextbook(),
                bresenhamTextbook(),
                bresenham(),
                midpoint(),
                clipFirstTextbook(),
                wu());
    }

    private static Method<LineRasterizer> naiveTextbook() {
        return new Method<>(
                "naive-textbook",
                new About(
                        "Y = K·(X − X1) + Y1, K = (Y2 − Y1)/(X2 − X1), rounded",
                        "every column from x0 to x1 gets one pixel",
                        "one multiplication, two additions and one rounding per column",
                        "gaps above 45°, nothing to the left, rubbish on verticals and single"
                                + " points, ties to the larger row, overflow from 2³⁰ on, endless"
                                + " up to the largest int",
                        PONOMAREV + "59"),
                new NaiveTextbookLine());
    }

    private static Method<LineRasterizer> naive() {
        return new Method<>(
                "naive",
                new About(
                        "s + ⌊k·i + ½ − 1/(4·n)⌋ across after i of n steps along, k = ±b/n",
                        "rounding errors stay below 1/(4·n), the distance to the next decision",
                        "one multiplication, two additions and one rounding per pixel",
                        "none known up to n = 2²⁴ steps; longer lines are refused",
                        "the definition of the line; error bound in the class's comment"),
                new NaiveLine());
    }

    private static Method<LineRasterizer> floatDda() {
        return new Method<>(
                "dda-float",
                new About(
                        "x ← x + dx/n, y ← y + dy/n, both in floats, both rounded",
                        "after i steps the rounding errors are up to i²·2⁻²⁵ pixels",
                        "two float additions and two roundings per pixel",
                        "leaves its course on long lines and far from the origin; stands still"
                                + " beyond 2²⁴, where not every pixel has a float",
                        KAZANTSEV
                                + "; J. D. Foley et al., Computer Graphics: Principles and"
                                + " Practice, 2nd edition, 1990, section 3.2.1"),
                new FloatDdaLine());
    }

    private static Method<LineRasterizer> dda() {
        return new Method<>(
                "dda",
                new About(
                        "f ← f + k, k = b/n; step across and take 1 off where f ≥ ½",
                        "f = k·i − j ∓ 1/(4·n) up to an error below 1/(4·n)",
                        "one floating-point addition and one comparison per pixel, a second"
                                + " addition where the line steps across",
                        "none known up to n = 2²⁴ steps; longer lines are refused",
                        "the digital differential analyser; error bound in the class's comment"),
                new DdaLine());
    }

    private static Method<LineRasterizer> bresenhamFirstTextbook() {
        return new Method<>(
                "bresenham-first-textbook",
                new About(
                        "D = 2·(i + 1)·dy − (2·j + 1)·dx; Y ← Y + 1 when D > 0",
                        "0 ≤ dy ≤ dx: the sign of D tells on which side of the middle the line"
                                + " passes",
                        "one integer addition and one comparison per column",
                        "gaps above 45°, one pixel to the left, never falls; overflow from 2³⁰ on,"
                                + " endless up to the largest int",
                        PONOMAREV + "63"),
                new BresenhamFirstTextbookLine());
    }

    private static Method<LineRasterizer> bresenhamPascalTextbook() {
        return new Method<>(
                "bresenham-pascal-textbook",
                new About(
                        "d = 2·(i + 1)·dy − (2·j + 1)·dx from the left end; y ← y + 1 when d ≥ 0",
                        "0 ≤ dy ≤ dx and the right end is not above the left one: the sign of d"
                                + " tells on which side of the middle the line passes",
                        "one integer addition and one comparison per column",
                        "y only grows, so lines that should fall rise; gaps above 45°, one pixel of"
                                + " a vertical, ties to the larger row, overflow from 2³⁰ on; as"
                                + " printed it lights the pixel after its loop and does not compile",
                        KAZANTSEV + ", procedure Bresenham"),
                new BresenhamPascalTextbookLine());
    }

    private static Method<LineRasterizer> clipFirstTextbook() {
        return new Method<>(
                "clip-first-textbook",
                new About(
                        "clip the segment to the window in real numbers, round the new ends, draw"
                                + " bresenham's line between them",
                        "none; rounding moves an end off the line by up to half a pixel",
                        "a clipping, then one integer addition and one comparison per pixel",
                        "turned by the rounding, so other pixels than the whole line's; nothing"
                                + " where the line passes less than half a pixel beside the window",
                        KAZANTSEV + ", procedure CLIP"),
                new ClipFirstTextbookLine());
    }

    private static Method<LineRasterizer> bresenhamTextbook() {
        return new Method<>(
                "bresenham-textbook",
                new About(
                        "d = 2·(i + 1)·b − (2·j + 1)·n; step across when d > 0",
                        "the sign of d tells on which side of the middle the line passes",
                        "one integer addition and one comparison per pixel",
                        "two pixels too many to the left and upward, a single point becomes two"
                                + " pixels, ties depend on the direction, overflow from 2³⁰ on,"
                                + " endless up to the largest int",
                        PONOMAREV + "65"),
                new BresenhamTextbookLine());
    }

    private static Method<LineRasterizer> bresenham() {
        return new Method<>(
                "bresenham",
                new About(
                        "d = 2·(i + 1)·b − (2·j + 1)·n − t; step across when d ≥ 0; t = 1 where"
                                + " the coordinate across does not fall, else 0",
                        "2·b − 2·n ≤ d < 2·b at every pixel",
                        "one integer addition and one comparison per pixel",
                        "none known for any int coordinates",
                        "J. E. Bresenham, Algorithm for computer control of a digital plotter,"
                                + " IBM Systems Journal 4(1), 1965"),
                new BresenhamLine());
    }

    private static Method<LineRasterizer> midpoint() {
        return new Method<>(
                "midpoint",
                new About(
                        "F(M) = 2·b·(u + 1) − n·(2·v + 1), M midway between the two candidates;"
                                + " step across when F(M) > 0",
                        "the sign of F(M) tells on which side of M the line passes",
                        "one integer addition, a second where the line steps across, and one"
                                + " comparison per pixel",
                        "none known for any int coordinates",
                        "M. L. V. Pitteway, Algorithm for drawing ellipses or hyperbolae with a"
                                + " digital plotter, Computer Journal 10(3), 1967"),
                new MidpointLine());
    }

    private static Method<LineRasterizer> wu() {
        return new Method<>(
                "wu",
                new About(
                        "coverage 1 − |f| for the nearest pixel, |f| for its neighbour on the"
                                + " line's side",
                        "the two coverages of a step add up to 1",
                        "dda's step and three additions, one multiplication, one rounding and three"
                                + " comparisons per pair of pixels",
                        "none known up to n = 2²⁴ steps; longer lines are refused",
                        "X. Wu, An efficient antialiasing technique, Computer Graphics 25(4),"
                                + " 1991"),
                new WuLine());
    }
}
